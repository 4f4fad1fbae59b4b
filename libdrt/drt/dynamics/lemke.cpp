#include <algorithm>
#include <cmath>
#include <optional>

#include "drt/dynamics/complementarity.h"

namespace drt {

namespace {

// Variables of one sign each, in the form of Stewart and Trinkle (1996): for a normal impulse one; for friction its
// part along and its part against its direction, and the speed at which it slips when it is at its limit:
//     x+, x- >= 0    with  w + slip >= 0, -w + slip >= 0;       slip >= 0    with  limit * x_normal - x+ - x- >= 0,
// where always one of the two is 0. The matrix is copositive, which is what Lemke's method needs to find a solution.
struct Variable {
    enum class Kind { impulse, slip } kind;
    int row;          // of the problem
    double sign = 1;  // of an impulse
    int normal = -1;  // of a slip: the variable of its normal impulse; its parts are the two variables before it
};

std::vector<Variable> make_variables(const Complementarity& c) {
    std::vector<Variable> out;
    std::vector<int> place(size_t(c.n), -1);
    using Kind = Variable::Kind;
    for (int i = 0; i < c.n; ++i) {
        if (c.normal[size_t(i)] >= 0 || c.at(i, i) <= 0) continue;
        place[size_t(i)] = int(out.size());
        out.push_back({Kind::impulse, i});
    }
    for (int i = 0; i < c.n; ++i) {
        const int normal = c.normal[size_t(i)];
        if (normal < 0 || c.at(i, i) <= 0 || place[size_t(normal)] < 0) continue;
        out.push_back({Kind::impulse, i, 1});
        out.push_back({Kind::impulse, i, -1});
        out.push_back({Kind::slip, i, 0, place[size_t(normal)]});
    }
    return out;
}

// Variable k and its complement m + k; one of the two is basic, that is its value may be other than 0, and
//     basic[i] = value[i] + sum over j of table[i][j] * other[j].
// The last column is Lemke's artificial variable, 2 m, which begins large and must become 0.
class Tableau {
public:
    Tableau(const Complementarity& c, const std::vector<Variable>& v, double perturbation)
        : m_(v.size()), width_(m_ + 1) {
        table_.resize(m_ * width_);
        value_.resize(m_);
        for (size_t i = 0; i < m_; ++i) basic_.push_back(i);
        for (size_t j = 0; j <= m_; ++j) other_.push_back(m_ + j);
        fill(c, v);
        for (size_t i = 0; i < m_; ++i) table_[i * width_ + m_] = 1;
        perturb(perturbation);
    }

    bool solve() {
        const size_t most_exchanges = 20 * m_ + 100;
        size_t column = m_;
        size_t row = size_t(std::min_element(value_.begin(), value_.end()) - value_.begin());
        if (m_ == 0 || value_[row] >= 0) return true;
        for (size_t k = 0; k < most_exchanges; ++k) {
            const size_t left = exchange(row, column);
            if (left == artificial()) return true;
            const size_t enters = left < m_ ? left + m_ : left - m_;  // the complement of what left
            column = size_t(std::find(other_.begin(), other_.end(), enters) - other_.begin());
            const std::optional<size_t> leaves = first_to_vanish(column);
            if (!leaves) return false;
            row = *leaves;
        }
        return false;
    }

    // Of the variables themselves, not of their complements.
    std::vector<double> values() const {
        std::vector<double> out(m_, 0);
        for (size_t i = 0; i < m_; ++i)
            if (basic_[i] >= m_ && basic_[i] < artificial()) out[basic_[i] - m_] = std::max(0.0, value_[i]);
        return out;
    }

private:
    static constexpr double smallest_pivot = 1e-9;

    size_t artificial() const { return 2 * m_; }

    // In units in which every impulse alone makes a speed of 1.
    void fill(const Complementarity& c, const std::vector<Variable>& v) {
        const auto unit = [&](int row) { return 1 / std::sqrt(c.at(row, row)); };
        for (size_t i = 0; i < m_; ++i) {
            const int row = v[i].row;
            double* out = &table_[i * width_];
            if (v[i].kind == Variable::Kind::slip) {
                const int normal = v[size_t(v[i].normal)].row;
                out[v[i].normal] = c.limit[size_t(row)] * unit(normal) / unit(row);
                out[i - 2] = out[i - 1] = -1;
                table_[(i - 2) * width_ + i] = table_[(i - 1) * width_ + i] = 1;
                continue;
            }
            value_[i] = v[i].sign * c.b[size_t(row)] * unit(row);
            for (size_t j = 0; j < m_; ++j)
                if (v[j].kind == Variable::Kind::impulse)
                    out[j] = v[i].sign * v[j].sign * c.at(row, v[j].row) * unit(row) * unit(v[j].row);
        }
    }

    // Ties, which many contacts have, could go round in circles.
    void perturb(double by) {
        double scale = 0;
        for (const double v : value_) scale = std::max(scale, std::abs(v));
        unsigned random = 1;
        for (double& v : value_) {
            random = random * 1664525u + 1013904223u;
            v += scale * by * (1 + random / 4294967296.0);
        }
    }

    // The variable of the column becomes basic in the place of the row's, which is returned.
    size_t exchange(size_t row, size_t column) {
        double* pivot_row = &table_[row * width_];
        const double inverse = 1 / pivot_row[column];
        for (size_t j = 0; j < width_; ++j) pivot_row[j] *= -inverse;
        pivot_row[column] = inverse;
        value_[row] *= -inverse;
        for (size_t i = 0; i < m_; ++i) {
            double* out = &table_[i * width_];
            const double factor = out[column];
            if (i == row || factor == 0) continue;
            out[column] = 0;
            for (size_t j = 0; j < width_; ++j) out[j] += factor * pivot_row[j];
            value_[i] += factor * value_[row];
        }
        std::swap(basic_[row], other_[column]);
        return other_[column];
    }

    // The basic variable that is 0 first as the column's grows: of several the one that changes most, which rounding
    // harms least; but the artificial one before all.
    std::optional<size_t> first_to_vanish(size_t column) const {
        double least = std::numeric_limits<double>::infinity();
        const auto rate = [&](size_t i) { return -table_[i * width_ + column]; };
        const auto when = [&](size_t i) { return std::max(0.0, value_[i]) / rate(i); };
        for (size_t i = 0; i < m_; ++i)
            if (rate(i) > smallest_pivot) least = std::min(least, when(i));
        std::optional<size_t> best;
        for (size_t i = 0; i < m_; ++i) {
            if (!(rate(i) > smallest_pivot) || when(i) > least * (1 + 1e-9) + 1e-14) continue;
            if (basic_[i] == artificial()) return i;
            if (!best || rate(i) > rate(*best)) best = i;
        }
        return best;
    }

    size_t m_, width_;
    std::vector<double> table_, value_;
    std::vector<size_t> basic_, other_;
};

}  // namespace

bool solve_by_pivoting(Complementarity& c, double perturbation) {
    const std::vector<Variable> variables = make_variables(c);
    Tableau tableau(c, variables, perturbation);
    if (!tableau.solve()) return false;
    std::fill(c.x.begin(), c.x.end(), 0);
    const std::vector<double> values = tableau.values();
    for (size_t k = 0; k < variables.size(); ++k)
        if (const Variable& v = variables[k]; v.kind == Variable::Kind::impulse)
            c.x[size_t(v.row)] += v.sign * values[k] / std::sqrt(c.at(v.row, v.row));
    return true;
}

}  // namespace drt

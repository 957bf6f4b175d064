namespace Harvester.Geometry.Calibration;

/// <summary>
/// A small linear least squares problem, row by row: finds p that minimises Σ w (row · p - target)². Solved by Cholesky factorisation of
/// the normal equations after the columns are scaled to unit length (Golub and Van Loan, Matrix Computations, 5.3).
/// </summary>
internal sealed class WeightedLeastSquares
{
    // With unit columns a pivot is the squared sine of a column's angle to the earlier ones; below this, noise of 1e-16 dominates.
    private const double MinPivot = 1e-10;
    private readonly int _count;
    private readonly double[,] _normal;
    private readonly double[] _right;
    private readonly double[] _scale;
    private readonly double[,] _factor;

    public WeightedLeastSquares(int parameterCount)
    {
        _count = parameterCount;
        _normal = new double[parameterCount, parameterCount];
        _factor = new double[parameterCount, parameterCount];
        _right = new double[parameterCount];
        _scale = new double[parameterCount];
    }

    public void Add(double[] row, double target, double weight)
    {
        for (int i = 0; i < _count; i++)
        {
            // Normal equations: Σ w·row·rowᵀ · p = Σ w·row·target; only the lower triangle is kept.
            _right[i] += weight * row[i] * target;
            for (int j = 0; j <= i; j++)
            {
                _normal[i, j] += weight * row[i] * row[j];
            }
        }
    }

    /// <summary>The solution; null if the rows do not determine all parameters.</summary>
    public double[]? Solve()
    {
        if (!Factorise())
        {
            return null;
        }

        // With S the scales and L the factor, S·N·S = L·Lᵀ: solve L·y = S·right, then Lᵀ·z = y; the solution is S·z.
        var scaled = new double[_count];
        for (int i = 0; i < _count; i++)
        {
            scaled[i] = _right[i] * _scale[i];
        }

        SolveLower(scaled);
        for (int i = _count - 1; i >= 0; i--)
        {
            for (int j = i + 1; j < _count; j++)
            {
                scaled[i] -= _factor[j, i] * scaled[j];
            }

            scaled[i] /= _factor[i, i];
        }

        for (int i = 0; i < _count; i++)
        {
            scaled[i] *= _scale[i];
        }

        return scaled;
    }

    /// <summary>After <see cref="Solve"/>: the variance of row · p if each target has variance 1.</summary>
    public double VarianceOf(double[] row)
    {
        // rowᵀ·N⁻¹·row = |L⁻¹·S·row|².
        var scaled = new double[_count];
        for (int i = 0; i < _count; i++)
        {
            scaled[i] = row[i] * _scale[i];
        }

        SolveLower(scaled);
        double sum = 0;
        foreach (double value in scaled)
        {
            sum += value * value;
        }

        return sum;
    }

    private bool Factorise()
    {
        for (int i = 0; i < _count; i++)
        {
            if (!(_normal[i, i] > 0))
            {
                return false;
            }

            _scale[i] = 1 / Math.Sqrt(_normal[i, i]);
            for (int j = 0; j <= i; j++)
            {
                // Cholesky, row by row: L[i,j] = (A[i,j] - Σ L[i,k]·L[j,k]) / L[j,j], and the root of the rest on the diagonal.
                double rest = _normal[i, j] * _scale[i] * _scale[j];
                for (int k = 0; k < j; k++)
                {
                    rest -= _factor[i, k] * _factor[j, k];
                }

                if (i == j && rest < MinPivot)
                {
                    return false;
                }

                _factor[i, j] = i == j ? Math.Sqrt(rest) : rest / _factor[j, j];
            }
        }

        return true;
    }

    private void SolveLower(double[] values)
    {
        for (int i = 0; i < _count; i++)
        {
            for (int j = 0; j < i; j++)
            {
                values[i] -= _factor[i, j] * values[j];
            }

            values[i] /= _factor[i, i];
        }
    }
}

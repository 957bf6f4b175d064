using Harvester.Geometry.Work;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// Finds how far a shape extends in a direction: rays continue from the points known to lie on it and, where it extends farthest, at
/// smaller distances, so that tips between the known points are found too.
/// </summary>
/// <param name="isOn">Whether the shape includes a point, given across the direction and along it, metres.</param>
/// <param name="step">Distance between the known points, metres.</param>
/// <param name="sign">1 towards larger numbers along the direction, -1 towards smaller ones.</param>
internal sealed class EdgeSearch(Func<double, double, bool> isOn, double step, int sign)
{
    /// <summary>A point is ignored if it extends the edge by less than this, metres.</summary>
    private const double MinGain = 0.001;

    /// <summary>Bisections of the step along the direction and, at the tip, across it.</summary>
    private const int Halvings = 4;

    /// <summary>One in this many known points is tried.</summary>
    private const int Stride = 2;

    /// <summary>Steps after which a shape is assumed to be endless, and the search ends.</summary>
    private const int MaxSteps = 1000;

    private double _across;
    private bool _isEndless;

    /// <summary>Where the shape ends, metres along the direction.</summary>
    public double End { get; private set; }

    /// <summary>Searches.</summary>
    /// <param name="known">Points on the shape, across the direction and along it, metres; at least one.</param>
    public IEnumerable<WorkStep> Run(IEnumerable<(double Across, double Along)> known)
    {
        (double Across, double Along)[] places = [.. known];
        (_across, End) = places.OrderByDescending(place => sign * place.Along).First();
        Follow();
        foreach (
            double across in places.Select(place => place.Across).Distinct().OrderBy(across => across).Where((_, i) => i % Stride == 0)
        )
        {
            Try(across);
            yield return WorkStep.Pause;
        }

        double beside = Stride * step;
        for (int i = 0; i < Halvings + Stride; i++)
        {
            while (Try(_across - beside) || Try(_across + beside))
            {
                yield return WorkStep.Pause;
            }

            yield return WorkStep.Pause;
            beside /= 2;
        }
    }

    /// <summary>Continues at a point across the direction, if the shape extends farther there.</summary>
    private bool Try(double across)
    {
        double further = End + (sign * MinGain);
        if (_isEndless || !isOn(across, further))
        {
            return false;
        }

        (_across, End) = (across, further);
        Follow();
        return true;
    }

    /// <summary>Follows the shape from a point on it to its end.</summary>
    private void Follow()
    {
        int steps = 0;
        while (steps < MaxSteps && isOn(_across, End + (sign * step)))
        {
            End += sign * step;
            steps++;
        }

        _isEndless = steps == MaxSteps;
        double part = step;
        for (int i = 0; i < Halvings; i++)
        {
            part /= 2;
            End += isOn(_across, End + (sign * part)) ? sign * part : 0;
        }
    }
}

namespace Harvester.Pages.Plots;

/// <summary>An axis of a plot.</summary>
/// <param name="Name">Quantity and unit, such as "speed, m/s".</param>
/// <param name="Min">The lower end.</param>
/// <param name="Max">The upper end, greater than the lower.</param>
public sealed record PlotAxis(string Name, double Min, double Max)
{
    private const double MarginFraction = 0.04;
    private const int MaxSteps = 8;

    /// <summary>Fraction of a step by which rounding may move a tick beyond the end of the axis.</summary>
    private const double Rounding = 1e-9;

    /// <summary>An axis for values in a range, slightly longer than the range, and never empty.</summary>
    public static PlotAxis Around(string name, double min, double max)
    {
        double margin = max > min ? MarginFraction * (max - min) : 1;
        return new PlotAxis(name, min - margin, max + margin);
    }

    /// <summary>At most nine round values on the axis: multiples of 1, 2 or 5 times a power of ten.</summary>
    public IEnumerable<double> Ticks()
    {
        double minStep = (Max - Min) / MaxSteps;
        double power = Math.Pow(10, Math.Floor(Math.Log10(minStep)));
        double step =
            power
            * (
                minStep <= power ? 1
                : minStep <= 2 * power ? 2
                : minStep <= 5 * power ? 5
                : 10
            );
        for (double tick = Math.Ceiling((Min / step) - Rounding); tick <= (Max / step) + Rounding; tick++)
        {
            yield return tick * step;
        }
    }
}

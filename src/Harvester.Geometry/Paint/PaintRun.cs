namespace Harvester.Geometry.Paint;

/// <summary>An unbroken piece of a painted line along a chain.</summary>
/// <param name="From">Where it begins, metres from the chain's start.</param>
/// <param name="To">Where it ends.</param>
/// <param name="BareBefore">Whether the ground before it was seen without paint.</param>
/// <param name="BareAfter">Whether the ground behind it was seen without paint.</param>
/// <param name="First">Index of its first stripe in the track.</param>
/// <param name="Last">Index of its last stripe in the track.</param>
internal readonly record struct PaintRun(double From, double To, bool BareBefore, bool BareAfter, int First, int Last)
{
    /// <summary>Longest dash, metres; what is longer is a solid line.</summary>
    private const double MaxDash = 6.5;

    public double Length => To - From;

    public bool IsSolid => Length > MaxDash;

    /// <summary>Whether it is a dash: short, and the line stops before or behind it.</summary>
    public bool IsDash => !IsSolid && (BareBefore || BareAfter);
}

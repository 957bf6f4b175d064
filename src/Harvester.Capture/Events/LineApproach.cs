namespace Harvester.Capture.Events;

/// <summary>A vehicle before a stop line.</summary>
/// <param name="first">How far its front was past the line when it was first seen there, metres; negative before it.</param>
internal sealed class LineApproach(double first)
{
    /// <summary>How far its front was past the line when it was first seen there, metres; negative before it.</summary>
    public double First => first;

    /// <summary>Its least horizontal speed so far, m/s.</summary>
    public double Slowest { get; set; } = double.PositiveInfinity;

    /// <summary>Whether the light was red when its front passed the line; null before.</summary>
    public bool? IsOnRed { get; set; }
}

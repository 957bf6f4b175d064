namespace Harvester.Simulation.Rendering;

/// <summary>How the simulated game's camera differs from a pinhole camera.</summary>
/// <param name="FocalScale">Factor on both focal lengths.</param>
/// <param name="CentreOffsetX">Shift of the principal point to the right, as a fraction of the width.</param>
/// <param name="CentreOffsetY">Shift of the principal point downward, as a fraction of the height.</param>
/// <param name="K1">Coefficient of r² in r' = r (1 + k1 r² + k2 r⁴).</param>
/// <param name="K2">Coefficient of r⁴.</param>
public readonly record struct RenderLens(double FocalScale, double CentreOffsetX, double CentreOffsetY, double K1, double K2)
{
    /// <summary>A pinhole camera.</summary>
    public static RenderLens None { get; } = new(1, 0, 0, 0, 0);

    /// <summary>Whether straight lines stay straight.</summary>
    public bool IsRectilinear => K1 == 0 && K2 == 0;
}

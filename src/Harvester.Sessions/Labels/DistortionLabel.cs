namespace Harvester.Sessions.Labels;

/// <summary>
/// Radial distortion r' = r (1 + k1 r² + k2 r⁴) of normalised image coordinates, and the focal scale that fx and fy already include.
/// </summary>
/// <param name="FocalScale">Factor already included in fx and fy.</param>
/// <param name="K1">Coefficient of r².</param>
/// <param name="K2">Coefficient of r⁴.</param>
public sealed record DistortionLabel(double FocalScale, double K1, double K2);

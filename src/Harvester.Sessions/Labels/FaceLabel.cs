using Harvester.Sessions.Faces;

namespace Harvester.Sessions.Labels;

/// <summary>The part of a label that only the face of a sign or the head of a traffic light has.</summary>
/// <param name="Number">Number of the face on its model, from 0.</param>
/// <param name="MutcdCode">Code in the Manual on Uniform Traffic Control Devices; null if it has none or it is unknown.</param>
/// <param name="FacingAngleDegrees">Angle between the direction in which the face looks and the direction from its middle to the camera, 0
/// to 180 degrees.</param>
/// <param name="Provenance">How the face's position on the model was obtained.</param>
/// <param name="Light">The state of the head of a traffic light; null for a sign.</param>
public sealed record FaceLabel(int Number, string? MutcdCode, double FacingAngleDegrees, Provenance Provenance, LightLabel? Light)
{
    /// <summary>Whether the camera is on the side towards which the face looks.</summary>
    public bool FacesCamera => IsBefore(FacingAngleDegrees);

    /// <summary>
    /// Whether a camera at an angle from the direction in which a face looks, degrees, is on the side towards which it looks.
    /// </summary>
    public static bool IsBefore(double facingAngleDegrees) => facingAngleDegrees < 90;
}

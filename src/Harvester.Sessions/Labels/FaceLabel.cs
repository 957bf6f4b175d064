using Harvester.Sessions.Faces;

namespace Harvester.Sessions.Labels;

/// <summary>What an object has that is a part of another: the face of a sign, a head of a traffic light.</summary>
/// <param name="Number">Number of the face on its model, from 0.</param>
/// <param name="MutcdCode">Code in the Manual on Uniform Traffic Control Devices; null when it has none or it is unknown.</param>
/// <param name="FacingAngleDegrees">Angle between the direction in which the face looks and the direction from its middle to the camera, 0
/// to 180 degrees.</param>
/// <param name="Provenance">How the face's place on the model was come by.</param>
/// <param name="Light">What the head of a traffic light shows; null for a sign.</param>
public sealed record FaceLabel(int Number, string? MutcdCode, double FacingAngleDegrees, Provenance Provenance, LightLabel? Light)
{
    /// <summary>Whether the camera is on the side towards which the face looks.</summary>
    public bool FacesCamera => IsBefore(FacingAngleDegrees);

    /// <summary>
    /// Whether a camera at an angle from the direction in which a face looks, degrees, is on the side towards which it looks.
    /// </summary>
    public static bool IsBefore(double facingAngleDegrees) => facingAngleDegrees < 90;
}

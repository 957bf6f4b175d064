using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>The game's scripted cameras. Those of other mods are never touched.</summary>
public interface ICameras
{
    /// <summary>Why this game cannot attach a camera to a vehicle, as a message for the player; null if it can.</summary>
    string? AttachingProblem { get; }

    /// <summary>Creates a fixed camera in the world.</summary>
    /// <param name="pose">Position (metres, world) and orientation.</param>
    /// <param name="verticalFovDegrees">Vertical field of view, degrees.</param>
    /// <returns>Its handle; 0 if the game creates none.</returns>
    int Make(Pose pose, double verticalFovDegrees);

    /// <summary>Attaches a camera to a vehicle with the vehicle's whole matrix.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="vehicle">The vehicle.</param>
    /// <param name="mount">Position (from the vehicle's origin, metres) and orientation in the vehicle's frame.</param>
    void Attach(int camera, int vehicle, Pose mount);

    /// <summary>Changes the field of view of a camera.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="verticalFovDegrees">Vertical field of view, degrees.</param>
    void Zoom(int camera, double verticalFovDegrees);

    /// <summary>Shows a camera's picture on the screen.</summary>
    void Show(int camera);

    /// <summary>Removes a camera, and restores the player's view if the camera was shown. It need not exist any more.</summary>
    void Remove(int camera);
}

using Harvester.Geometry;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Surveys.Faces;

/// <summary>Photographs the model on the stage. All calls come from the game's own thread.</summary>
public interface ISurveyCamera
{
    /// <summary>Shows the world from a position, a few ticks later, until the next call.</summary>
    /// <param name="eye">Position (metres, world) and orientation.</param>
    /// <param name="verticalFovDegrees">Vertical field of view, degrees.</param>
    /// <returns>Whether the game made a camera.</returns>
    bool LookFrom(Pose eye, double verticalFovDegrees);

    /// <summary>The middle square of the current picture; null if the picture is not usable.</summary>
    PixelBuffer? Grab();

    /// <summary>Restores the player's view. Calling it again has no effect.</summary>
    void LookAway();
}

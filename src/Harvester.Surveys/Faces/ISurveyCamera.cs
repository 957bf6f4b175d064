using Harvester.Geometry;
using Harvester.Sessions.Imaging;

namespace Harvester.Surveys.Faces;

/// <summary>Photographs what stands on the stage. All calls come from the game's own thread.</summary>
public interface ISurveyCamera
{
    /// <summary>Shows the world from a place, in some ticks, until another is looked from.</summary>
    /// <param name="eye">Position (metres, world) and orientation.</param>
    /// <param name="verticalFovDegrees">Vertical field of view, degrees.</param>
    /// <returns>Whether the game made a camera.</returns>
    bool LookFrom(Pose eye, double verticalFovDegrees);

    /// <summary>The middle square of the picture shown now; null when the picture cannot be trusted.</summary>
    PixelBuffer? Grab();

    /// <summary>Gives the view back. Again is no harm.</summary>
    void LookAway();
}

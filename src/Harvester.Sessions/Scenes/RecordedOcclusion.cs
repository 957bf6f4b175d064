using Harvester.Geometry.Visibility;

namespace Harvester.Sessions.Scenes;

/// <summary>
/// What a harvest found out about an entity in the image, or one of its faces, that cannot be recomputed without the game.
/// </summary>
/// <param name="Handle">The entity's handle.</param>
/// <param name="Face">Number of the face on its model; null for the entity itself.</param>
/// <param name="Id">Its id in labels, even if it was not listed because it is hidden.</param>
/// <param name="Sight">Whether any of it was visible.</param>
/// <param name="Method">How the occlusion was determined.</param>
/// <param name="OccludedFraction">Fraction of its silhouette in the image that is hidden, 0 to 1; 0 if it was not determined.</param>
/// <param name="SetLight">The state to which this traffic light was set; null for everything else.</param>
public sealed record RecordedOcclusion(
    int Handle,
    int? Face,
    int Id,
    Sight Sight,
    OcclusionMethod Method,
    double OccludedFraction,
    LightState? SetLight
)
{
    /// <summary>The finding as an estimate.</summary>
    public OcclusionEstimate Estimate => new(OccludedFraction, 0, 0, Method) { Sight = Sight };

    /// <summary>Records an estimate.</summary>
    public static RecordedOcclusion Of(int handle, int? face, int id, OcclusionEstimate estimate, LightState? setLight) =>
        new(handle, face, id, estimate.Sight, estimate.Method, estimate.OccludedFraction, setLight);
}

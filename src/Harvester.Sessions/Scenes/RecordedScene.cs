using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Scenes;

/// <summary>
/// Everything from which a frame's labels were made, so that they can be recomputed without the game and with other options.
/// </summary>
/// <param name="Snapshot">The scene, with everything within the labelling range, labelled or not.</param>
/// <param name="Lens">The lens used for the labels.</param>
/// <param name="Ids">The ids of entities in labels, by handle; not all of them have one.</param>
/// <param name="Occlusions">The findings about the entities and faces in the image.</param>
public sealed record RecordedScene(
    SceneSnapshot Snapshot,
    Lens Lens,
    IReadOnlyDictionary<int, int> Ids,
    IReadOnlyList<RecordedOcclusion> Occlusions
)
{
    /// <summary>The entities beyond the labelling range that are in the image, and whether they were visible.</summary>
    public IReadOnlyList<DistantEntity> Distant { get; init; } = [];
}

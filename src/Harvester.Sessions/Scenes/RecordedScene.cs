using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Scenes;

/// <summary>All that a frame's labels were made from, so that they can be made again without the game, in another way.</summary>
/// <param name="Snapshot">The scene, with everything within the labelling range, labelled or not.</param>
/// <param name="Lens">The lens that was labelled with.</param>
/// <param name="Ids">The numbers that entities have in labels, by handle; not all of them have one.</param>
/// <param name="Occlusions">What was found of the entities and faces in the image.</param>
public sealed record RecordedScene(
    SceneSnapshot Snapshot, Lens Lens, IReadOnlyDictionary<int, int> Ids, IReadOnlyList<RecordedOcclusion> Occlusions)
{
    /// <summary>What was found of the entities beyond the labelling range that are in the image.</summary>
    public IReadOnlyList<DistantEntity> Distant { get; init; } = [];
}

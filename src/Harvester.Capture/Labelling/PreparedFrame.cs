using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// What follows from a snapshot before anything is photographed or a ray is cast. Photographs and labels of a frame use the same one, so
/// that the numbers of the objects in both agree.
/// </summary>
/// <param name="draft">The frame in progress, without labels.</param>
/// <param name="candidates">The objects that may be labelled.</param>
internal sealed class PreparedFrame(FrameDraft draft, List<LabelCandidate> candidates)
{
    private MapTarget[]? _targets;

    /// <summary>The frame in progress.</summary>
    public FrameDraft Draft => draft;

    /// <summary>The state that the image shows.</summary>
    public SceneSnapshot Snapshot => draft.Snapshot;

    /// <summary>The camera of the saved image.</summary>
    public Camera Camera => draft.Camera;

    /// <summary>The objects that may be labelled.</summary>
    public List<LabelCandidate> Candidates => candidates;

    /// <summary>
    /// The candidates as targets of a mask, in their order. Which objects are kept is known only after the mask, so until then they have
    /// consecutive numbers from 1.
    /// </summary>
    public IReadOnlyList<MapTarget> Targets =>
        _targets ??= [
            .. candidates.Select(
                (candidate, index) => new MapTarget(candidate.Entity.Handle, (ushort)(index + 1), candidate.Cuboid, candidate.Projection)
            ),
        ];
}

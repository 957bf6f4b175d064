using Harvester.Geometry.Visibility;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The occlusions that a harvest found in one frame, as far as they still hold. The same object seen from the same position is hidden by
/// the same things, so they hold for every entity, and for a face whose position on its model is unchanged. With another lens, a different
/// part of an object may be inside the image: they then hold for objects completely inside the image, and a completely hidden object stays
/// hidden.
/// </summary>
internal sealed class RecordedOcclusions(RecordedScene scene, FrameLabel recorded, LabellingOptions recordedOptions, bool isLensSame)
{
    private readonly Dictionary<(int Handle, int? Face), RecordedOcclusion> _found = scene.Occlusions.ToDictionary(found =>
        (found.Handle, found.Face)
    );

    private readonly Dictionary<int, ObjectLabel> _labels = recorded.Objects.ToDictionary(label => label.Id);

    /// <summary>The recorded label with an id; null if it was not listed.</summary>
    public ObjectLabel? LabelOf(int id) => _labels.TryGetValue(id, out ObjectLabel? label) ? label : null;

    /// <summary>The occlusion of an entity in the image.</summary>
    public OcclusionEstimate Of(LabelCandidate candidate)
    {
        ObjectLabel? label = LabelOf(candidate.Id);
        return ImportedIn(label) ?? Found(candidate, null, label);
    }

    /// <summary>The occlusion of a face in the image.</summary>
    public OcclusionEstimate Of(FaceCandidate candidate)
    {
        ModelFace face = candidate.Face;
        ModelFace? before = recordedOptions.Faces?.Of(face.Hash).FirstOrDefault(each => each.Number == face.Number);
        bool isPlaceSame =
            before is not null
            && (before.FrontUpperLeft, before.BackLowerRight, before.Facing, before.Provenance)
                == (face.FrontUpperLeft, face.BackLowerRight, face.Facing, face.Provenance);
        ObjectLabel? label = LabelOf(candidate.Seen.Id);
        return isPlaceSame ? ImportedIn(label) ?? Found(candidate.Seen, face.Number, label) : default;
    }

    private OcclusionEstimate? ImportedIn(ObjectLabel? label) =>
        isLensSame && label is { OcclusionMethod: OcclusionMethod.Imported, OccludedFraction: { } imported }
            ? new OcclusionEstimate(imported, 0, 0, OcclusionMethod.Imported) { Sight = imported < 1 ? Sight.Seen : Sight.Unseen }
            : null;

    private OcclusionEstimate Found(LabelCandidate candidate, int? face, ObjectLabel? label)
    {
        if (!_found.TryGetValue((candidate.Entity.Handle, face), out RecordedOcclusion? found))
        {
            return default;
        }

        bool isWhole = candidate.Projection.TruncatedFraction == 0 && label?.TruncatedFraction == 0;
        bool holds =
            isLensSame || isWhole || found.Sight == Sight.Undetermined || found.OccludedFraction > recordedOptions.MaxOccludedFraction;
        return holds ? found.Estimate
            : found.Sight == Sight.Seen ? new OcclusionEstimate { Sight = Sight.Seen }
            : default;
    }
}

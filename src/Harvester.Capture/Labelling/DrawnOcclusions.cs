using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>Adds to the labels of a frame how much of each object the drawing hides.</summary>
internal static class DrawnOcclusions
{
    /// <summary>Sets <see cref="ObjectLabel.TrueOccludedFraction"/> of all objects but parts of others.</summary>
    /// <param name="draft">The frame, with the ids of its entities.</param>
    /// <param name="image">Size of the image, pixels.</param>
    /// <param name="drawn">The drawing.</param>
    public static void Add(FrameDraft draft, ImageSize image, IDrawnOcclusion drawn)
    {
        Dictionary<int, int> handles = draft.Ids.ToDictionary(static pair => pair.Value, static pair => pair.Key);
        int[] asked =
        [
            .. draft.Objects.Where(label => label.Parent is null && handles.ContainsKey(label.Id)).Select(label => handles[label.Id]),
        ];
        IReadOnlyDictionary<int, double> hidden = drawn.HiddenFractions(asked, image);
        draft.Update(label =>
            label.Parent is null && handles.TryGetValue(label.Id, out int handle) && hidden.TryGetValue(handle, out double fraction)
                ? label with
                {
                    TrueOccludedFraction = fraction,
                }
                : label
        );
    }
}

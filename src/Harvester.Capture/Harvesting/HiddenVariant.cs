using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>Objects of a moment that its pictures are also taken without.</summary>
/// <param name="Number">Number among the variants of the moment, from 1.</param>
/// <param name="Name">Name of the choice.</param>
/// <param name="Handles">Handles of the entities.</param>
/// <param name="Ids">Ids of the objects and their parts, in ascending order.</param>
/// <param name="Boxes">Their boxes in the image, pixels.</param>
internal sealed record HiddenVariant(
    int Number,
    string Name,
    IReadOnlyList<int> Handles,
    IReadOnlyList<int> Ids,
    IReadOnlyList<Box2D> Boxes
)
{
    /// <summary>Whether the game let the objects be hidden.</summary>
    public bool IsHidden { get; set; }

    /// <summary>The variants of a moment, in the order of the choices; a choice that finds no object has none.</summary>
    public static IReadOnlyList<HiddenVariant> Of(FrameDraft draft, IEnumerable<HiddenChoice> choices)
    {
        Dictionary<int, int> handles = draft
            .Occlusions.GroupBy(found => found.Id)
            .ToDictionary(found => found.Key, found => found.First().Handle);
        IGrouping<int, ObjectLabel>[] entities =
        [
            .. draft.Objects.Where(label => handles.ContainsKey(label.Id)).GroupBy(label => handles[label.Id]),
        ];
        return
        [
            .. choices
                .Select(choice => (choice.Name, Handles: WithRiders(draft, choice.Of(entities).Select(entity => entity.Key))))
                .Where(variant => variant.Handles.Count > 0)
                .Select(
                    (variant, number) =>
                        (
                            variant,
                            number,
                            Labels: entities.Where(entity => variant.Handles.Contains(entity.Key)).SelectMany(entity => entity).ToArray()
                        )
                )
                .Select(each => new HiddenVariant(
                    each.number + 1,
                    each.variant.Name,
                    each.variant.Handles,
                    [.. each.Labels.Select(label => label.Id).OrderBy(static id => id)],
                    [.. each.Labels.Select(label => label.Box2D)]
                )),
        ];
    }

    /// <summary>Some entities and the riders of those that are two-wheelers: nobody rides a vehicle that is not there.</summary>
    private static IReadOnlyList<int> WithRiders(FrameDraft draft, IEnumerable<int> handles)
    {
        int[] chosen = [.. handles];
        return
        [
            .. chosen,
            .. draft
                .Snapshot.Entities.Where(entity => entity.VehicleHandle is { } vehicle && chosen.Contains(vehicle))
                .Select(entity => entity.Handle)
                .Except(chosen),
        ];
    }
}

using System.Collections.Generic;
using System.Linq;
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
    int Number, string Name, IReadOnlyList<int> Handles, IReadOnlyList<int> Ids, IReadOnlyList<Box2D> Boxes)
{
    /// <summary>Whether the game let the objects be hidden.</summary>
    public bool IsHidden { get; set; }

    /// <summary>The variants of a moment, in the order of the choices; a choice that finds no object has none.</summary>
    public static IReadOnlyList<HiddenVariant> Of(FrameDraft draft, IEnumerable<HiddenChoice> choices)
    {
        Dictionary<int, int> handles = draft.Occlusions.GroupBy(found => found.Id).ToDictionary(
            found => found.Key, found => found.First().Handle);
        IGrouping<int, ObjectLabel>[] entities =
            [.. draft.Objects.Where(label => handles.ContainsKey(label.Id)).GroupBy(label => handles[label.Id])];
        return [.. choices.Select(choice => (choice.Name, Entities: choice.Of(entities))).Where(variant => variant.Entities.Count > 0)
            .Select((variant, number) => new HiddenVariant(
                number + 1,
                variant.Name,
                [.. variant.Entities.Select(entity => entity.Key)],
                [.. variant.Entities.SelectMany(entity => entity).Select(label => label.Id).OrderBy(static id => id)],
                [.. variant.Entities.SelectMany(entity => entity).Select(label => label.Box2D)]))];
    }
}

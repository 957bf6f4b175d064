using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Formats.Cityscapes;

/// <summary>
/// Writes maps in the style of Cityscapes' gtFine: instance ids, label ids and training ids as greyscale PNGs, and polygons. See
/// docs/exports/cityscapes.md.
/// </summary>
internal sealed class CityscapesWriter(ExportOptions options) : IDatasetWriter
{
    private readonly PngEncoder _png = new();

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        InstanceMap mask = options.Parts == PartSelection.None ? frame.Mask! : frame.DividedMask!;
        Dictionary<int, ushort> ids = InstanceIds(frame);
        string city = $"session{frame.RecordingIndex:D4}";
        string name = $"{city}_{frame.SequenceIndex:D6}_{frame.FrameInSequence:D6}";
        output.Image($"leftImg8bit/{frame.Split}/{city}/{name}_leftImg8bit{frame.ImageExtension}", frame);
        string maps = $"gtFine/{frame.Split}/{city}/{name}_gtFine_";
        InstanceMap instances = Map(mask, value => ids.GetValueOrDefault(value));
        if (frame.Classes is { } classes)
        {
            InstanceMap surfaces = Map(classes, value => CityscapesLabels.OfSurface((SemanticClass)value).Id);
            for (int i = 0; i < instances.Ids.Length; i++)
            {
                instances.Ids[i] = mask.Ids[i] == 0 ? surfaces.Ids[i] : instances.Ids[i];
            }
        }

        output.File(maps + "instanceIds.png", stream => _png.Write(instances, stream));
        InstanceMap labels = Map(instances, id => CityscapesLabels.OfInstance(id)!.Id);
        output.File(maps + "labelIds.png", stream => _png.WriteGrey8(labels, stream));
        InstanceMap trainIds = Map(instances, id => CityscapesLabels.OfInstance(id)!.TrainId);
        output.File(maps + "labelTrainIds.png", stream => _png.WriteGrey8(trainIds, stream));
        output.Text(maps + "polygons.json", CityscapesPolygons.Text(instances) + "\n");
        HashSet<ushort> seen = [.. mask.Ids.Distinct()];
        return new WrittenObjects(frame.Objects.Count(item => seen.Contains((ushort)item.Label.Id)));
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) => [];

    /// <summary>
    /// Instances are numbered from 0 within their label, in the order of object ids. Objects that are not exported have no entry and become
    /// unlabeled.
    /// </summary>
    private Dictionary<int, ushort> InstanceIds(ExportFrame frame)
    {
        Dictionary<int, ushort> ids = frame.Label.Objects.Where(frame.IsPost).ToDictionary(post => post.Id, _ => CityscapesLabels.Pole.Id);
        var counts = new Dictionary<ushort, int>();
        foreach (ExportObject item in frame.Objects)
        {
            CityscapesLabel label = CityscapesLabels.Of(item.Label.Class, options.Names);
            int number = counts.GetValueOrDefault(label.Id);
            counts[label.Id] = number + 1;
            if (label.HasInstances && number == CityscapesLabels.InstancesPerLabel)
            {
                throw frame.Problem("it has more than 1,000 objects of a class, for which cityscapes has no numbers.");
            }

            ids.Add(item.Label.Id, label.HasInstances ? (ushort)((label.Id * CityscapesLabels.InstancesPerLabel) + number) : label.Id);
        }

        return ids;
    }

    private static InstanceMap Map(InstanceMap map, System.Func<ushort, ushort> valueOf)
    {
        var mapped = new InstanceMap(map.Image);
        (ushort from, ushort to) = ((ushort)0, valueOf(0));
        for (int i = 0; i < map.Ids.Length; i++)
        {
            if (map.Ids[i] != from)
            {
                from = map.Ids[i];
                to = valueOf(from);
            }

            mapped.Ids[i] = to;
        }

        return mapped;
    }
}

using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Imaging;
using Harvester.Capture.Labels;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Exports.Cityscapes;

/// <summary>Maps in the style of Cityscapes' gtFine: instance ids and label ids as grey PNGs. See docs/exports/cityscapes.md.</summary>
internal sealed class CityscapesWriter : IDatasetWriter
{
    private readonly PngEncoder _png = new();

    public int Write(ExportFrame frame, FrameOutput output)
    {
        InstanceMap mask = frame.Mask!;
        Dictionary<int, ushort> instances = InstanceIds(frame);
        string city = $"session{frame.SessionIndex:D4}";
        string name = $"{city}_{0:D6}_{frame.FrameInSession:D6}";
        output.Transfer($"leftImg8bit/{frame.Split}/{city}/{name}_leftImg8bit{frame.ImageExtension}", frame.ImagePath);
        string maps = $"gtFine/{frame.Split}/{city}/{name}_gtFine_";
        InstanceMap instanceMap = Map(mask, instances);
        output.File(maps + "instanceIds.png", stream => _png.Write(instanceMap, stream));
        Dictionary<int, ushort> labels = instances.ToDictionary(pair => pair.Key, pair => CityscapesLabels.LabelOfInstance(pair.Value));
        InstanceMap labelMap = Map(mask, labels);
        output.File(maps + "labelIds.png", stream => _png.WriteGrey8(labelMap, stream));
        return mask.Ids.Distinct().Count(id => instances.ContainsKey(id));
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) => [];

    /// <summary>Instances count from 0 within their class, in the order of the objects' ids.</summary>
    private static Dictionary<int, ushort> InstanceIds(ExportFrame frame)
    {
        var counts = new Dictionary<ushort, int>();
        var ids = new Dictionary<int, ushort>();
        foreach (ObjectLabel item in frame.Objects)
        {
            (ushort label, bool hasInstances) = CityscapesLabels.Of(item.Class);
            int number = counts.GetValueOrDefault(label);
            counts[label] = number + 1;
            if (hasInstances && number == CityscapesLabels.InstancesPerLabel)
            {
                throw frame.Problem("it has more than 1,000 objects of a class, for which cityscapes has no numbers.");
            }

            ids.Add(item.Id, hasInstances ? (ushort)((label * CityscapesLabels.InstancesPerLabel) + number) : label);
        }

        return ids;
    }

    private static InstanceMap Map(InstanceMap mask, Dictionary<int, ushort> values)
    {
        var map = new InstanceMap(mask.Image);
        for (int i = 0; i < map.Ids.Length; i++)
        {
            map.Ids[i] = values.GetValueOrDefault(mask.Ids[i]);
        }

        return map;
    }
}

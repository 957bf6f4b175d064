using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Imaging;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Exports.Cityscapes;

/// <summary>Maps in the style of Cityscapes' gtFine: instance ids and label ids as grey PNGs. See docs/exports/cityscapes.md.</summary>
internal sealed class CityscapesWriter : IDatasetWriter
{
    private const int InstancesPerLabel = 1000;

    private readonly PngEncoder _png = new();

    public void Write(ExportFrame frame, FrameOutput output)
    {
        InstanceMap mask = frame.Mask!;
        Dictionary<int, ushort> instances = InstanceIds(frame);
        string city = $"session{frame.SessionIndex:D4}";
        string name = $"{city}_{0:D6}_{frame.FrameInSession:D6}";
        output.Transfer($"leftImg8bit/{frame.Split}/{city}/{name}_leftImg8bit{frame.ImageExtension}", frame.ImagePath);
        string maps = $"gtFine/{frame.Split}/{city}/{name}_gtFine_";
        InstanceMap instanceMap = Map(mask, instances);
        output.File(maps + "instanceIds.png", stream => _png.Write(instanceMap, stream));
        Dictionary<int, ushort> labels = instances.ToDictionary(pair => pair.Key, pair => LabelIdOf(pair.Value));
        InstanceMap labelMap = Map(mask, labels);
        output.File(maps + "labelIds.png", stream => _png.WriteGrey8(labelMap, stream));
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) => [];

    /// <summary>The label id of an instance id, which is the label id itself for classes without instances.</summary>
    private static ushort LabelIdOf(ushort instance) => instance >= InstancesPerLabel ? (ushort)(instance / InstancesPerLabel) : instance;

    /// <summary>Instances count from 0 within their class, in the order of the objects' ids.</summary>
    private static Dictionary<int, ushort> InstanceIds(ExportFrame frame)
    {
        var counts = new Dictionary<ushort, int>();
        var ids = new Dictionary<int, ushort>();
        foreach (ObjectLabel item in frame.Objects)
        {
            (ushort label, bool hasInstances) = LabelOf(item.Class);
            int number = counts.GetValueOrDefault(label);
            counts[label] = number + 1;
            if (hasInstances && number == InstancesPerLabel)
            {
                throw frame.Problem("it has more than 1,000 objects of a class, for which cityscapes has no numbers.");
            }

            ids.Add(item.Id, hasInstances ? (ushort)((label * InstancesPerLabel) + number) : label);
        }

        return ids;
    }

    /// <summary>The label ids of the benchmark's table.</summary>
    private static (ushort Label, bool HasInstances) LabelOf(ObjectClass kind) => kind switch
    {
        ObjectClass.Car => (26, true),
        ObjectClass.Truck => (27, true),
        ObjectClass.Bus => (28, true),
        ObjectClass.Trailer => (30, true),
        ObjectClass.Motorcycle => (32, true),
        ObjectClass.Bicycle => (33, true),
        ObjectClass.Pedestrian => (24, true),
        ObjectClass.TrafficLight => (19, false),
        ObjectClass.Sign => (20, false),
        ObjectClass.Other => (5, false),
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "The class has no label in Cityscapes."),
    };

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

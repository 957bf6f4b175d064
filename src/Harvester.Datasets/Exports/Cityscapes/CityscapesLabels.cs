using System;
using System.Linq;
using Harvester.Capture.Scenes;

namespace Harvester.Datasets.Exports.Cityscapes;

/// <summary>The label ids of the benchmark's table, and how instances are numbered: label · 1000 + number for labels with instances.</summary>
internal static class CityscapesLabels
{
    public const int InstancesPerLabel = 1000;

    /// <summary>The label of a class, and whether its objects are told apart.</summary>
    public static (ushort Label, bool HasInstances) Of(ObjectClass kind) => kind switch
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

    /// <summary>The label id of an instance id, which is the label id itself for classes without instances.</summary>
    public static ushort LabelOfInstance(ushort instance) => instance >= InstancesPerLabel ? (ushort)(instance / InstancesPerLabel) : instance;

    /// <summary>Whether a number can stand in a map of instances: 0 for nothing, or one of a label above.</summary>
    public static bool IsInstance(ushort instance) =>
        instance == 0 || Enum.GetValues<ObjectClass>().Select(Of).Contains((LabelOfInstance(instance), instance >= InstancesPerLabel));
}

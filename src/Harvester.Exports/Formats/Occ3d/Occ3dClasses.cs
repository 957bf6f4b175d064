using Harvester.Geometry.Grids;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Formats.Occ3d;

/// <summary>
/// The classes of Occ3D-nuScenes: those of the nuScenes-lidarseg challenge, and free (github.com/Tsinghua-MARS-Lab/Occ3D, README). See
/// docs/exports/occ3d.md.
/// </summary>
internal static class Occ3dClasses
{
    /// <summary>The class of a voxel that nothing occupies, which is the greatest.</summary>
    public const byte Free = 17;

    private const byte Others = 0;
    private const byte Bicycle = 2;
    private const byte Bus = 3;
    private const byte Car = 4;
    private const byte Motorcycle = 6;
    private const byte Pedestrian = 7;
    private const byte Trailer = 9;
    private const byte Truck = 10;
    private const byte DriveableSurface = 11;
    private const byte OtherFlat = 12;
    private const byte Sidewalk = 13;
    private const byte Terrain = 14;
    private const byte Manmade = 15;
    private const byte Vegetation = 16;

    /// <summary>The class of a voxel by its value in the map, except for riders, who have the class of their vehicle.</summary>
    public static byte Of(ushort value) =>
        value is VoxelMap.Free or VoxelMap.Enclosed
            ? Free
            : (SemanticClass)value switch
            {
                SemanticClass.Road or SemanticClass.LaneMarking => DriveableSurface,
                SemanticClass.Water => OtherFlat,
                SemanticClass.Pavement => Sidewalk,
                SemanticClass.Terrain => Terrain,
                SemanticClass.Building or SemanticClass.Pole or SemanticClass.Fence or SemanticClass.Sign or SemanticClass.TrafficLight =>
                    Manmade,
                SemanticClass.Vegetation => Vegetation,
                SemanticClass.Car => Car,
                SemanticClass.Truck => Truck,
                SemanticClass.Bus => Bus,
                SemanticClass.Motorcycle => Motorcycle,
                SemanticClass.Bicycle => Bicycle,
                SemanticClass.Trailer => Trailer,
                SemanticClass.Pedestrian => Pedestrian,
                _ => Others,
            };

    /// <summary>The class of a rider by the vehicle, which is null if it is not known.</summary>
    public static byte OfRider(ObjectClass? vehicle) =>
        vehicle switch
        {
            ObjectClass.Motorcycle => Motorcycle,
            ObjectClass.Bicycle => Bicycle,
            _ => Others,
        };
}

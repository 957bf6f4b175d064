namespace Harvester.Exports.Maps;

/// <summary>The formats for the lanes of a road network. The command line, its help and its errors read this list.</summary>
public static class MapFormats
{
    /// <summary>All formats.</summary>
    public static IReadOnlyList<MapFormat> All { get; } =
    [
        new("opendrive", ".xodr", "ASAM OpenDRIVE 1.7", OpenDriveMap.Write),
        new("lanelet2", ".osm", "Lanelet2 as OpenStreetMap XML", (map, _, stream) => Lanelet2Map.Write(map, stream)),
        new("nuscenes", ".json", "nuScenes map expansion 1.3", (map, _, stream) => NuScenesExpansion.Write(map, stream)),
        new("argoverse2", ".json", "Argoverse 2 vector map", (map, _, stream) => ArgoverseMap.Write(map, stream)),
        new("geojson", ".geojson", "GeoJSON in metres", (map, _, stream) => GeoJsonMap.Write(map, stream)),
    ];
}

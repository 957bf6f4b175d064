using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The file that says where the map of each scene lies in the world.</summary>
internal static class NuScenesMapOffsets
{
    /// <summary>Name of the file, in the folder of the tables.</summary>
    public const string Name = "map_offset";

    /// <summary>The offset and size of a scene's map, metres.</summary>
    public static Action<Utf8JsonWriter> Of(NuScenesScene scene) =>
        json =>
        {
            json.WriteString("log_token", scene.LogToken);
            json.WriteString("filename", NuScenesMap.PathOf(scene.Name));
            json.Numbers("offset", [scene.Area.Offset.X, scene.Area.Offset.Y], 0);
            json.Numbers("size", [scene.Area.Width, scene.Area.Height], 0);
        };
}

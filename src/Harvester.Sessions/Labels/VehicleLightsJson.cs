using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes the lamps of a vehicle, in labels and scenes alike.</summary>
internal static class VehicleLightsJson
{
    /// <summary>Appends the key <c>lights</c>; nothing if they are unknown.</summary>
    public static void Append(JsonText json, VehicleLights? lights)
    {
        if (lights is { } known)
        {
            json.Key("lights")
                .BeginObject()
                .Key("brake")
                .Boolean(known.Brake)
                .Key("left")
                .Boolean(known.Left)
                .Key("right")
                .Boolean(known.Right)
                .Key("head")
                .Boolean(known.Head)
                .EndObject();
        }
    }
}

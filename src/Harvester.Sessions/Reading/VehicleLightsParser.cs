using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Reading;

/// <summary>Reads the lamps of a vehicle, in labels and scenes alike.</summary>
internal static class VehicleLightsParser
{
    /// <summary>The field <c>lights</c> of an object; null if it is absent.</summary>
    public static VehicleLights? Parse(JsonFields entity)
    {
        if (!entity.Has("lights"))
        {
            return null;
        }

        JsonFields lights = entity.Fields("lights");
        return new VehicleLights(lights.Boolean("brake"), lights.Boolean("left"), lights.Boolean("right"), lights.Boolean("head"));
    }
}

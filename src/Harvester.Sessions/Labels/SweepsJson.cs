using System.Collections.Generic;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes the LiDARs of a label.</summary>
internal static class SweepsJson
{
    /// <summary>Writes them, with their key; nothing if there are none.</summary>
    public static void Append(JsonText json, IReadOnlyList<SweepLabel> sweeps)
    {
        if (sweeps.Count == 0)
        {
            return;
        }

        json.Key("lidar").BeginArray();
        foreach (SweepLabel sweep in sweeps)
        {
            json.BeginObject()
                .Key("sensor").String(sweep.Sensor)
                .Key("file").String(sweep.File)
                .Key("points").Integer(sweep.Points)
                .Key("raysCast").Integer(sweep.RaysCast)
                .EndObject();
        }

        json.EndArray();
    }
}

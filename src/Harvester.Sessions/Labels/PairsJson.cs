using System.Collections.Generic;
using System.Globalization;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes the further pictures of a frame.</summary>
internal static class PairsJson
{
    /// <summary>Writes them, with their key; nothing if there are none.</summary>
    public static void Append(JsonText json, IReadOnlyList<PairLabel> pairs)
    {
        if (pairs.Count == 0)
        {
            return;
        }

        json.Key("pairs").BeginArray();
        foreach (PairLabel pair in pairs)
        {
            json.BeginObject()
                .Key("file").String(pair.File)
                .Key("weather").String(pair.Weather)
                .Key("timeOfDay").String(pair.TimeOfDay.ToString(@"hh\:mm\:ss", CultureInfo.InvariantCulture))
                .Key("without").BeginArray();
            foreach (int id in pair.Without)
            {
                json.Integer(id);
            }

            json.EndArray();
            if (pair.Dropped is { } dropped)
            {
                json.Key("dropped").String(JsonName.Of(dropped));
            }

            json.EndObject();
        }

        json.EndArray();
    }
}

using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Coco;

/// <summary>Checks the elements of the lists in a JSON file, one by one.</summary>
internal static class CocoElements
{
    /// <summary>The problems of the elements, with their lines.</summary>
    /// <param name="dataset">The dataset.</param>
    /// <param name="name">The file.</param>
    /// <param name="problemOf">The problem of an element of a list; null for none.</param>
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset, string name, Func<string, JsonFields, string?> problemOf)
    {
        using var reader = new JsonListReader(dataset.PathOf(name));
        while (true)
        {
            bool hasElement = TryRead(reader, name, out SessionProblem? damage);
            if (damage is not null)
            {
                yield return damage;
            }

            if (!hasElement)
            {
                yield break;
            }

            if (ProblemOf(reader, problemOf) is { } problem)
            {
                yield return new SessionProblem(name, reader.Line, problem);
            }
        }
    }

    private static bool TryRead(JsonListReader reader, string name, out SessionProblem? damage)
    {
        try
        {
            damage = null;
            return reader.Read();
        }
        catch (JsonException e)
        {
            damage = new SessionProblem(name, (int?)(e.LineNumber + 1), JsonFault.InLine(e));
            return false;
        }
        catch (DatasetFormatException e)
        {
            damage = new SessionProblem(name, null, e.Message);
            return false;
        }
    }

    private static string? ProblemOf(JsonListReader reader, Func<string, JsonFields, string?> problemOf)
    {
        try
        {
            return problemOf(reader.List, new JsonFields(reader.Element));
        }
        catch (DatasetFormatException e)
        {
            return $"{reader.List}: {e.Message}";
        }
    }
}

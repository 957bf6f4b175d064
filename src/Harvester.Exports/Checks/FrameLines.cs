using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Checks;

/// <summary>JSON files with an object per line, which are read line by line, so that they may have any length.</summary>
internal static class FrameLines
{
    private const string Begin = "[";
    private const string End = "]";

    /// <summary>Checks every object of a file without brackets around its lines.</summary>
    /// <param name="dataset">The dataset.</param>
    /// <param name="name">The file.</param>
    /// <param name="problemOf">The problem of an object; null for none.</param>
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset, string name, Func<JsonFields, string?> problemOf)
    {
        if (!dataset.Has(name))
        {
            yield return new SessionProblem(name, null, "it is missing.");
        }

        foreach ((int number, string text) in dataset.Lines(name))
        {
            if (ProblemOf(text, problemOf) is { } problem)
            {
                yield return new SessionProblem(name, number, problem);
            }
        }
    }

    /// <summary>Checks every object of a file that is a list.</summary>
    /// <param name="dataset">The dataset.</param>
    /// <param name="name">The file.</param>
    /// <param name="problemOf">The problem of an object; null for none.</param>
    public static IEnumerable<SessionProblem> ListProblems(DatasetContent dataset, string name, Func<JsonFields, string?> problemOf)
    {
        if (!dataset.Has(name))
        {
            yield return new SessionProblem(name, null, "it is missing.");
            yield break;
        }

        string last = "";
        foreach ((int number, string text) in dataset.Lines(name))
        {
            string? problem =
                number == 1
                    ? text == Begin
                        ? null
                        : $"it does not begin with a line '{Begin}'."
                    : last == End
                        ? $"a line follows the line '{End}'."
                        : text == End
                            ? null
                            : ProblemOf(text.EndsWith(',') ? text[..^1] : text, problemOf);
            if (problem is not null)
            {
                yield return new SessionProblem(name, number, problem);
            }

            last = text;
        }

        if (last != End)
        {
            yield return new SessionProblem(name, null, $"it is cut off: a line '{End}' must end it.");
        }
    }

    /// <summary>The problem of an object as text.</summary>
    public static string? ProblemOf(string text, Func<JsonFields, string?> problemOf)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(text);
            return problemOf(new JsonFields(document.RootElement));
        }
        catch (JsonException e)
        {
            return JsonFault.InLine(e);
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }
}

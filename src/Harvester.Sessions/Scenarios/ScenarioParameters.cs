using Harvester.Sessions.Text;

namespace Harvester.Sessions.Scenarios;

/// <summary>The parameters of a scenario file.</summary>
internal static class ScenarioParameters
{
    private const int Most = 30;
    private const double Reach = 1e6;

    /// <summary>The parameters that a file has.</summary>
    /// <exception cref="FormatException">The file or one of them is wrong; the message names it.</exception>
    public static ScenarioParameter[] Of(string text)
    {
        CheckedJson file = CheckedJson.Parse(text, "a scenario");
        if (file.Fields("parameters") is not { } fields)
        {
            return [];
        }

        ScenarioParameter[] parameters = [.. fields.Names.ToList().Select(name => Of(fields, name))];
        return parameters.Length <= Most ? parameters : throw file.Wrong("parameters", $"an object of at most {Most} parameters");
    }

    /// <summary>Values with which a file is tried: all in the middle, all at one end, all at the other, and each of a list.</summary>
    public static IEnumerable<IReadOnlyDictionary<string, double>> Probes(IReadOnlyList<ScenarioParameter> parameters)
    {
        yield return parameters.ToDictionary(
            each => each.Name,
            each => each.Values.Count > 0 ? each.Values[each.Values.Count / 2] : (each.Min + each.Max) / 2
        );
        if (parameters.Count > 0)
        {
            yield return parameters.ToDictionary(each => each.Name, each => each.Min);
            yield return parameters.ToDictionary(each => each.Name, each => each.Max);
        }
    }

    private static ScenarioParameter Of(CheckedJson fields, string name)
    {
        if (!char.IsLetter(name[0]) || !ScenarioParser.IsName(name) || name.IndexOf('-') >= 0)
        {
            throw fields.Wrong(name, "called by 1 to 30 letters and digits, beginning with a letter");
        }

        if (fields.IsList(name))
        {
            double[] values = fields.Numbers(name, -Reach, Reach);
            return values.Length is > 0 and <= 100
                ? new ScenarioParameter(name, values.Min(), values.Max()) { Values = values }
                : throw fields.Wrong(name, "a list of 1 to 100 numbers");
        }

        if (fields.IsObject(name))
        {
            CheckedJson range = fields.Fields(name)!;
            double min = range.Number("min", -Reach, Reach);
            double max = range.Number("max", -Reach, Reach);
            range.End();
            return min <= max ? new ScenarioParameter(name, min, max) : throw fields.Wrong(name, "a range whose min is not above its max");
        }

        double value = fields.Number(name, -Reach, Reach);
        return new ScenarioParameter(name, value, value);
    }
}

namespace Harvester.Sessions.Scenarios;

/// <summary>A scenario file: a scenario for every seed.</summary>
public sealed class ScenarioTemplate
{
    private readonly string _text;

    internal ScenarioTemplate(string text, Scenario middle, IReadOnlyList<ScenarioParameter> parameters) =>
        (_text, Middle, Parameters) = (text, middle, parameters);

    /// <summary>The scenario with every parameter in the middle of its range.</summary>
    public Scenario Middle { get; }

    /// <summary>The parameters, in the order of the file.</summary>
    public IReadOnlyList<ScenarioParameter> Parameters { get; }

    /// <summary>The scenario with the parameters that a seed gives.</summary>
    public Scenario Drawn(int seed) =>
        ScenarioParser.Read(_text, Parameters.ToDictionary(parameter => parameter.Name, parameter => parameter.Drawn(seed)));
}

using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Scenarios;

/// <summary>harvester scenario show: prints what a scenario does with a seed.</summary>
internal static class ScenarioShowCommand
{
    private const string Notes =
        "Prints name, kind and description, a line for each parameter with its range and the value of the seed, and the actors and\n"
        + "events with these values.\n\n"
        + "Example:\n"
        + "  harvester scenario show data/scenarios/cut-in-left.json --seed 7";

    public static Command Create(Terminal terminal)
    {
        Argument<FileInfo> file = ScenarioCommand.FileArgument();
        Option<int> seed = ValueParsers.Integer("--seed", "N", "Seed from which the parameters are drawn", 0, int.MaxValue);
        seed.DefaultValueFactory = _ => 1;
        var command = new ResultCommand("show", "Print what a scenario does with a seed.") { file, seed };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, _) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(file), parsed.GetValue(seed))));
        return command;
    }

    private static int Run(Terminal terminal, FileInfo file, int seed)
    {
        ScenarioTemplate template = ScenarioCommand.Read(file);
        Scenario scenario = template.Drawn(seed);
        terminal.WriteQuoting($"{scenario.Name} ({scenario.Kind}): {scenario.Description}");
        foreach (ScenarioParameter parameter in template.Parameters)
        {
            double drawn = scenario.Values[parameter.Name];
            terminal.WriteQuoting(
                FormattableString.Invariant(
                    $"  {parameter.Name}  {parameter.Min:0.###} to {parameter.Max:0.###}, with seed {seed}: {drawn:0.###}"
                )
            );
        }

        terminal.WriteQuoting(FormattableString.Invariant($"ego  {scenario.Ego.Speed:0.0} m/s, {JsonName.Of(scenario.Ego.Turn)}"));
        foreach (ScenarioActor actor in scenario.Actors)
        {
            string speed = FormattableString.Invariant($"{actor.Speed ?? scenario.Ego.Speed:0.0} m/s");
            terminal.WriteQuoting($"actor {actor.Id}  {JsonName.Of(actor.Type)} {actor.Model}, {JsonName.Of(actor.Start.Kind)}, {speed}");
        }

        foreach (ScenarioEvent each in scenario.Events)
        {
            string[] when = [.. each.When.Select(TextOf)];
            terminal.WriteQuoting(
                $"event {each.Id}  {each.Actor}: {JsonName.Of(each.Action.Kind)}"
                    + (when.Length == 0 ? " at once" : $" when {string.Join(each.IsAny ? " or " : " and ", when)}")
            );
        }

        return ExitCode.Done;
    }

    private static string TextOf(ScenarioCondition condition)
    {
        string value =
            condition.Event
            ?? (
                condition.Kind == ScenarioConditionKind.Light
                    ? JsonName.Of(condition.Light)
                    : FormattableString.Invariant($"{condition.Value:0.##}")
            );
        return $"{JsonName.Of(condition.Kind)} {value}{(condition.Actor is { } actor ? $" of {actor}" : "")}";
    }
}

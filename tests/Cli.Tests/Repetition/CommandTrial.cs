using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>A writing command with the folder before and after it, by which runs that were stopped are judged.</summary>
internal sealed class CommandTrial
{
    private readonly string _inputs;
    private readonly string _folder;

    /// <summary>Makes what the command finds, and runs it once without disturbance.</summary>
    /// <param name="command">The command.</param>
    /// <param name="inputs">The folder of <see cref="MakeInputs"/>.</param>
    /// <param name="folder">A folder of the trial's own.</param>
    public CommandTrial(WritingCommand command, string inputs, string folder)
    {
        Command = command;
        _inputs = inputs;
        _folder = folder;
        string root = Path.Combine(folder, "whole");
        Directory.CreateDirectory(root);
        foreach (string words in command.Before)
        {
            Assert.Equal((ExitCode.Done, ""), EndingOf(Run(words, root)));
        }

        Folders.Copy(root, BeforeIn(folder));
        Former = ContentOf(root);
        Assert.Equal((ExitCode.Done, ""), EndingOf(Run(root)));
        Expected = ContentOf(root);
    }

    public WritingCommand Command { get; }

    /// <summary>The folder before the command.</summary>
    public FolderContent Former { get; }

    /// <summary>The folder after it.</summary>
    public FolderContent Expected { get; }

    /// <summary>Makes the inputs of all commands.</summary>
    public static void MakeInputs(string inputs)
    {
        Directory.CreateDirectory(inputs);
        File.WriteAllText(Path.Combine(inputs, "roads.csv"), WritingCommand.Roads);
        File.WriteAllText(Path.Combine(inputs, "places.csv"), WritingCommand.Places);
        File.WriteAllText(Path.Combine(inputs, "plan.json"), WritingCommand.Plan);
        File.WriteAllText(Path.Combine(inputs, "scenario.json"), WritingCommand.Scenario);
        File.WriteAllText(Path.Combine(inputs, "recipe.json"), WritingCommand.Recipe);
        foreach (string words in WritingCommand.Inputs)
        {
            Assert.Equal((ExitCode.Done, ""), EndingOf(CliRun.Of(WritingCommand.WordsOf(words, inputs, ""))));
        }

        // An export of people that finds none would write nothing of its own.
        Assert.Contains("\"joint\":", File.ReadAllText(Path.Combine(inputs, "people/labels.jsonl")), StringComparison.Ordinal);
    }

    /// <summary>The folder before the command, in the folder of its trial.</summary>
    public static string BeforeIn(string folder) => Path.Combine(folder, "before");

    /// <summary>The content of a folder without signs of life, of which each run has its own.</summary>
    public static FolderContent ContentOf(string root) => FolderContent.Of(root).Without(name => name == "out/heartbeat.json");

    /// <summary>The content of a folder without what a stopped command may leave; it is gone after the next.</summary>
    public static FolderContent ResultIn(string root) =>
        ContentOf(root)
            .Without(name => name.Contains(".partial", StringComparison.Ordinal) || name.Contains(".harvester-", StringComparison.Ordinal));

    /// <summary>Whether each result is whole, the old one or the new one.</summary>
    public bool IsWhole(FolderContent left) =>
        left
            .Tops.Union(Former.Tops)
            .Union(Expected.Tops)
            .All(top => left.In(top).Equals(Former.In(top)) || left.In(top).Equals(Expected.In(top)));

    /// <summary>Makes a folder what it is before the command.</summary>
    public void Restore(string root)
    {
        if (Directory.Exists(root))
        {
            Directory.Delete(root, recursive: true);
        }

        Folders.Copy(BeforeIn(_folder), root);
    }

    /// <summary>Runs the command.</summary>
    public CliRun Run(string root) => Run(Command.Words, root);

    /// <summary>Gives the command again where it was stopped.</summary>
    /// <param name="root">The folder.</param>
    /// <param name="left">What the stopped command left there.</param>
    /// <returns>What is wrong; null if it ends as if it had not been stopped.</returns>
    public string? FaultOfRepetition(string root, FolderContent left)
    {
        CliRun again = Run(root);
        bool wasOver =
            again.ExitCode == ExitCode.Usage && again.Error.Contains("already has", StringComparison.Ordinal) && left.Equals(Expected);
        if (again.ExitCode != ExitCode.Done && !wasOver)
        {
            return $"given again it ends with {again.ExitCode}: {again.Error.TrimEnd()}";
        }

        FolderContent result = ContentOf(root);
        return result.Equals(Expected) ? null : $"given again it has another result: {result.DifferenceFrom(Expected)}";
    }

    private static (int Code, string Error) EndingOf(CliRun run) => (run.ExitCode, run.Error);

    private CliRun Run(string words, string root)
    {
        string[] arguments = WritingCommand.WordsOf(words, _inputs, root);
        return arguments[0] == "serve" ? ServedRun.Of(arguments) : CliRun.Of(arguments);
    }
}

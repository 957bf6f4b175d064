using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Recipes;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Runs.Supervising;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester rebuild: makes a dataset from its recipe, and compares it with the digests of a locked one.</summary>
internal sealed class RebuildCommand
{
    private const string Notes =
        "A recipe is a JSON file with the commands that make a dataset, in their order, each with the folder that it writes. A\n"
        + "dataset can so be passed on without its images. The folder --out receives the folders of the steps and the file\n"
        + "dataset.lock: the recipe with the digests of its inputs and of the folders. Given to this command on another machine, it\n"
        + "says whether the bytes are the same; if they are not, the exit code is 1. A command that was stopped continues when it is\n"
        + "given again. docs/rebuild.md has details.\n\n"
        + "Examples:\n"
        + "  harvester rebuild data/recipes/four-weathers.json --out dataset\n"
        + "  harvester rebuild dataset/dataset.lock --out again\n"
        + "  harvester rebuild city.json --out city --input roads=extracted/paths --check";

    /// <summary>A sign of life, whose content is the time.</summary>
    private static readonly string[] Timed = [HeartbeatReader.FileName];

    private readonly Argument<FileInfo> _recipe = new("RECIPE") { Description = "Recipe or dataset.lock" };

    private readonly Option<string> _out = new("--out")
    {
        Description = "Folder to write the dataset to",
        HelpName = "DIR",
        Required = true,
    };

    private readonly Option<string[]> _inputs = new("--input")
    {
        Description = "A file or folder that the recipe names, such as roads=FILE; repeatable",
        HelpName = "NAME=FILE",
        DefaultValueFactory = _ => [],
    };

    private readonly Option<bool> _check = new("--check") { Description = "Only check the recipe and its inputs" };

    public static Command Create(Terminal terminal) => new RebuildCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("rebuild", "Make a dataset from its recipe, and compare it with the original's digests.")
        {
            _recipe,
            _out,
            _inputs,
            _check,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => RunAsync(terminal, parsed, cancellation));
        return command;
    }

    private async Task<int> RunAsync(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        string file = parsed.GetRequiredValue(_recipe).FullName;
        DatasetRecipe recipe = DatasetRecipe.Read(file);
        Dictionary<string, string> paths = InputsOf(recipe, parsed.GetValue(_inputs) ?? []);
        Check(terminal, file, recipe);
        RecipeInput[] inputs = [.. recipe.Inputs.Select(input => input with { Sha256 = DigestOf(input, paths[input.Name], cancellation) })];
        if (recipe.Tool is { } tool && tool != SimulatedHarvest.ToolText)
        {
            terminal.WriteError($"The dataset was made by {tool}, and this is {SimulatedHarvest.ToolText}: the bytes may differ.");
        }

        if (parsed.GetValue(_check))
        {
            terminal.Out.WriteLine($"{file}: {Counted.Of(recipe.Steps.Count, "step")}, {Counted.Of(inputs.Length, "input")}, no problems");
            return ExitCode.Done;
        }

        string folder = Path.GetFullPath(parsed.GetRequiredValue(_out));
        using var output = new RunsOutput(folder, CommandText.Of(parsed), DatasetRecipe.FileName);
        output.Begin();
        var steps = new List<RecipeStep>();
        foreach (RecipeStep step in recipe.Steps)
        {
            string written = Path.Combine(folder, step.Folder);
            terminal.Out.WriteLine($"Step {steps.Count + 1} of {recipe.Steps.Count}, {step.Folder}: {step.Command[0]}");
            string[] line = RecipeWords.LineOf(step, paths, written, words => Application.Parse(words, terminal));
            int code = await Application.RunAsync(line, terminal, cancellation).ConfigureAwait(false);
            if (code != ExitCode.Done)
            {
                terminal.WriteError($"The step '{step.Folder}' ended with exit code {code}. To continue, give the same command again.");
                return code;
            }

            paths.Add(step.Folder, written);
            steps.Add(step with { Sha256 = FolderDigest.Of(written, Timed, cancellation) });
        }

        output.Complete(new DatasetRecipe(SimulatedHarvest.ToolText, inputs, steps).Write);
        return Compare(terminal, folder, recipe.Steps, steps);
    }

    private static int Compare(Terminal terminal, string folder, IReadOnlyList<RecipeStep> expected, List<RecipeStep> made)
    {
        string[] different =
        [
            .. expected
                .Zip(made)
                .Where(pair => pair.First.Sha256 is { } sha && sha != pair.Second.Sha256)
                .Select(pair => pair.First.Folder),
        ];
        if (different.Length > 0)
        {
            terminal.WriteError($"'{folder}' is not the dataset of the recipe: {string.Join(", ", different)} has other bytes.");
            return ExitCode.BadData;
        }

        int compared = expected.Count(step => step.Sha256 is not null);
        string result = compared > 0 ? $"{compared} with the same bytes as the original" : $"locked in {DatasetRecipe.FileName}";
        terminal.Out.WriteLine($"{folder}: {Counted.Of(made.Count, "folder")}, {result}");
        return ExitCode.Done;
    }

    private static void Check(Terminal terminal, string file, DatasetRecipe recipe)
    {
        var known = recipe.Inputs.Select(input => input.Name).ToHashSet(StringComparer.Ordinal);
        foreach (RecipeStep step in recipe.Steps)
        {
            try
            {
                RecipeWords.Check(step, known, words => Application.Parse(words, terminal));
            }
            catch (DatasetFormatException e)
            {
                throw new DatasetFormatException($"{file}: {e.Message}", e);
            }

            known.Add(step.Folder);
        }
    }

    private static string DigestOf(RecipeInput input, string path, CancellationToken cancellation)
    {
        string digest = Directory.Exists(path) ? FolderDigest.Of(path, Timed, cancellation) : FileDigest.OfFile(path).Sha256;
        return input.Sha256 is null || input.Sha256 == digest
            ? digest
            : throw new DatasetFormatException($"{path}: this is not the input '{input.Name}' of the recipe; its SHA-256 is another.");
    }

    private static Dictionary<string, string> InputsOf(DatasetRecipe recipe, string[] given)
    {
        var paths = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (string text in given)
        {
            string[] parts = text.Split('=', 2);
            if (parts is not [var name, { Length: > 0 } path] || !recipe.Inputs.Any(input => input.Name == name))
            {
                string names = string.Join(", ", recipe.Inputs.Select(input => input.Name));
                string known = names.Length > 0 ? $"Inputs: {names}." : "The recipe has no inputs.";
                throw new UsageException($"--input '{text}' is not of the form NAME=FILE. {known}");
            }

            if (!paths.TryAdd(name, Path.GetFullPath(path)))
            {
                throw new UsageException($"--input {name} is given more than once.");
            }
        }

        return recipe.Inputs.FirstOrDefault(input => !paths.ContainsKey(input.Name)) is { } missing
            ? throw new UsageException($"The recipe needs the input '{missing.Name}'. Add --input {missing.Name}=FILE.")
            : paths;
    }
}

using System.CommandLine;
using Harvester.Cli.Commands;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests;

public sealed class ApplicationTests
{
    [Fact]
    public void Help_lists_commands_and_exit_codes()
    {
        CliRun run = CliRun.Of("--help");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        foreach (string command in (string[])["harvest", "validate", "report", "project", "boxes"])
        {
            Assert.Contains($"\n  {command} ", run.Out, StringComparison.Ordinal);
        }

        Assert.Contains("130  stopped by Ctrl+C", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Help_lists_the_exit_codes_of_the_docs()
    {
        string help = CliRun.Of("--help").Out;
        string docs = File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "command-line.md"));

        string[] rows = [.. docs.Split('\n').Where(line => line.Length > 2 && line[0] == '|' && char.IsAsciiDigit(line[2]))];
        Assert.Equal(8, rows.Length);
        Assert.All(rows, row => Assert.Contains(InHelp(row.Split('|')), help, StringComparison.Ordinal));

        // The docs say more of SIGTERM than fits into the help.
        static string InHelp(string[] cells) =>
            $"\n  {cells[1].Trim(), -5}"
            + $"{cells[2].Trim().Replace(", which `kill`, `timeout` and batch systems send", "", StringComparison.Ordinal)}\n";
    }

    private static Terminal Silent => new(TextReader.Null, TextWriter.Null, TextWriter.Null, IsInteractive: false);

    public static TheoryData<string> Commands => [.. CommandsWithin("")];

    [Theory]
    [MemberData(nameof(Commands))]
    public void Help_of_each_command_names_each_option_and_default_once(string command)
    {
        string[] lines = CliRun.Of([.. command.Split(' '), "--help"]).Out.Split('\n');

        string[] options =
        [
            .. lines.Where(line => line.StartsWith("  -", StringComparison.Ordinal)).Select(line => line.Trim().Split(' ')[0]),
        ];
        Assert.Equal(options.Distinct(), options);
        Assert.Contains("-?,", options);
        Assert.All(lines, line => Assert.InRange(line.Split("[default:").Length, 1, 2));
    }

    [Theory]
    [MemberData(nameof(Commands))]
    public void Help_with_many_options_has_each_under_a_heading(string command)
    {
        const int most = 20;
        string help = CliRun.Of([.. command.Split(' '), "--help"]).Out;
        string[] all = [.. OptionsOf(help)];
        string[] general = [.. OptionsOf(Section(help, "General"))];

        // Every command has --help and --quiet, which belong to no subject.
        Assert.Equal(all.Length > most, !help.Contains("\nOptions:\n", StringComparison.Ordinal));
        Assert.Equal(all.Length > most ? ["-?", "-q"] : [], general);

        static IEnumerable<string> OptionsOf(string text) =>
            text.Split('\n').Where(line => line.StartsWith("  -", StringComparison.Ordinal)).Select(line => line.Trim().Split(' ', ',')[0]);

        static string Section(string text, string heading) =>
            text.Split($"\n{heading}:\n") is [_, var rest, ..] ? rest.Split("\n\n")[0] : "";
    }

    [Theory]
    [InlineData("harvest")]
    [InlineData("drive")]
    [InlineData("serve")]
    [InlineData("export")]
    [InlineData("relabel")]
    public void Groups_of_the_help_have_every_option_once(string command)
    {
        IReadOnlyList<OptionGroup> groups = command switch
        {
            "harvest" => OptionGroups.OfHarvest,
            "drive" => OptionGroups.OfDrive,
            "serve" => OptionGroups.OfServe,
            "export" => OptionGroups.OfExport,
            _ => OptionGroups.OfRelabel,
        };
        Command made = command switch
        {
            "harvest" => HarvestCommand.Create(Silent),
            "drive" => DriveCommand.Create(Silent),
            "serve" => ServeCommand.Create(Silent),
            "export" => ExportCommand.Create(Silent),
            _ => RelabelCommand.Create(Silent),
        };

        Assert.Equal(
            made.Options.Select(option => option.Name).Where(name => name != "--help").Order(),
            groups.SelectMany(group => group.Options).Order()
        );
    }

    [Fact]
    public void No_command_is_a_usage_error() => CliRun.Of().AssertFailed(ExitCode.Usage, "harvester --help");

    [Fact]
    public void Unknown_command_is_a_usage_error() => CliRun.Of("harvset").AssertFailed(ExitCode.Usage, "harvset");

    [Fact]
    public void Usage_error_of_a_subcommand_names_both_help_pages() =>
        CliRun.Of("roads", "info").AssertFailed(ExitCode.Usage, "harvester roads info --help");

    [Theory]
    [InlineData("harvest", "--out", "")]
    [InlineData("report", "session", "--out", "")]
    [InlineData("boxes", "")]
    public void Empty_value_is_a_usage_error(params string[] arguments) => CliRun.Of(arguments).AssertFailed(ExitCode.Usage, "empty");

    [Fact]
    public void Error_quoting_a_file_is_truncated_and_free_of_control_codes()
    {
        CliRun run = CliRun.WithInput(
            "\u001b[2J" + new string('x', 5000) + "\n",
            "project",
            "--position",
            "0,0,0",
            "--rotation",
            "0,0,0",
            "--fov",
            "50",
            "--size",
            "800x600"
        );

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.StartsWith("harvester: standard input, line 1: expected x,y,z, found '[2Jxxx", run.Error, StringComparison.Ordinal);
        Assert.InRange(run.Error.Length, 100, 700);
    }

    [Fact]
    public async Task Output_that_cannot_be_written_is_an_output_error()
    {
        var error = new StringWriter { NewLine = "\n" };
        var full = new StreamWriter(new FullStream());
        var terminal = new Terminal(TextReader.Null, full, error, IsInteractive: false);

        int code = await Application.RunAsync(["--help"], terminal, CancellationToken.None);

        Assert.Equal(ExitCode.InputOutput, code);
        Assert.Equal("harvester: No space left.\n", error.ToString());
    }

    [Fact]
    public void Unknown_option_is_a_usage_error_that_names_the_commands_help() =>
        CliRun.Of("boxes", "scene.json", "--depth").AssertFailed(ExitCode.Usage, "harvester boxes --help");

    [Theory]
    [InlineData("doctor", "--bogus")]
    [InlineData("validate", "--bogus")]
    [InlineData("spaces", "check", "--bogus")]
    public void Misspelt_option_is_not_taken_for_a_file(params string[] arguments) =>
        CliRun.Of(arguments).AssertFailed(ExitCode.Usage, "Unrecognised argument '--bogus'.");

    [Fact]
    public void Word_after_a_double_dash_is_a_file() =>
        CliRun.Of("validate", "--", "--bogus").AssertFailed(ExitCode.InputOutput, "Folder not found: '--bogus'.");

    [Theory]
    [InlineData("A command is missing. See 'harvester --help'.")]
    [InlineData("A command is missing. See 'harvester masks --help'.", "masks")]
    [InlineData("DIR is missing. See 'harvester masks import --help'.", "masks", "import", "session")]
    [InlineData("SESSION is missing.", "stats")]
    [InlineData("--frames needs a value.", "harvest", "--out", "session", "--frames")]
    public void Missing_word_is_named(string message, params string[] arguments) =>
        CliRun.Of(arguments).AssertFailed(ExitCode.Usage, message);

    [Theory]
    [InlineData("--images", "move", "link or copy")]
    [InlineData("--segmentation", "dots", "rle or polygon")]
    [InlineData("--parts", "some", "faces, all, none or only")]
    public void Unknown_choice_is_a_usage_error_that_lists_the_choices(string option, string value, string choices) =>
        CliRun
            .Of("export", "session", "--format", "coco", "--out", "coco", option, value)
            .AssertFailed(ExitCode.Usage, $"{option} takes {choices}, not '{value}'.");

    [Theory]
    [MemberData(nameof(Commands))]
    public void Help_of_each_command_ends_with_examples_of_itself(string command)
    {
        CliRun run = CliRun.Of([.. command.Split(' '), "--help"]);
        string help = run.Out;
        string[] examples =
        [
            .. help.Split('\n')
                .SkipWhile(line => !line.StartsWith("Example", StringComparison.Ordinal))
                .Skip(1)
                .Where(line => line.Length > 0),
        ];

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.NotEmpty(examples);
        Assert.All(examples, line => Assert.Contains($"harvester {command} ", line + " ", StringComparison.Ordinal));
        Assert.DoesNotContain("Exit codes", help, StringComparison.Ordinal);
    }

    internal static IEnumerable<string> CommandsWithin(string command)
    {
        string help = CliRun.Of([.. command.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--help"]).Out;
        int list = help.IndexOf("\nCommands:\n", StringComparison.Ordinal);
        string[] names =
            list < 0
                ? []
                : [.. help[(list + "\nCommands:\n".Length)..].Split("\n\n")[0].Split('\n').Select(line => line.Trim().Split(' ')[0])];
        return names.Select(name => $"{command} {name}".Trim()).SelectMany(name => CommandsWithin(name).Prepend(name));
    }

    /// <summary>A stream on a full disk.</summary>
    private sealed class FullStream : MemoryStream
    {
        public override void Write(byte[] buffer, int offset, int count) => Refuse();

        public override void Write(ReadOnlySpan<byte> buffer) => Refuse();

        public override Task WriteAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken)
        {
            Refuse();
            return Task.CompletedTask;
        }

        public override ValueTask WriteAsync(ReadOnlyMemory<byte> buffer, CancellationToken cancellationToken = default)
        {
            Refuse();
            return default;
        }

        private static void Refuse() => throw new IOException("No space left.");
    }
}

using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;

namespace Harvester.Cli.Terminals;

/// <summary>The help of a command, with its options in groups if it has many, followed by notes such as examples.</summary>
internal sealed class HelpWithNotes : SynchronousCommandLineAction
{
    private readonly HelpAction _help;
    private readonly string _notes;

    private readonly IReadOnlyList<OptionGroup>? _groups;

    private HelpWithNotes(HelpAction help, string notes, IReadOnlyList<OptionGroup>? groups)
    {
        _help = help;
        _notes = notes;
        _groups = groups;
    }

    public override bool ClearsParseErrors => true;

    /// <summary>Gives a command its own --help, which ends with notes.</summary>
    /// <param name="command">The command.</param>
    /// <param name="notes">The notes.</param>
    /// <param name="groups">The groups of its options; null for one list.</param>
    public static void AddTo(Command command, string notes, IReadOnlyList<OptionGroup>? groups = null)
    {
        HelpOption? option = command.Options.OfType<HelpOption>().FirstOrDefault();
        if (option is null)
        {
            // Subcommands without notes keep the help option of the root.
            option = new HelpOption { Recursive = false };
            command.Options.Add(option);
        }

        option.Action = new HelpWithNotes((HelpAction)option.Action!, notes, groups);
    }

    public override int Invoke(ParseResult parseResult)
    {
        TextWriter output = parseResult.InvocationConfiguration.Output;
        int code = _groups is null ? _help.Invoke(parseResult) : WriteGrouped(parseResult, _groups);
        output.WriteLine(_notes);
        return code;
    }

    private int WriteGrouped(ParseResult parseResult, IReadOnlyList<OptionGroup> groups)
    {
        InvocationConfiguration configuration = parseResult.InvocationConfiguration;
        TextWriter output = configuration.Output;
        using var help = new StringWriter();
        configuration.Output = help;
        int code = _help.Invoke(parseResult);
        configuration.Output = output;
        output.Write(GroupedHelp.Of(help.ToString(), groups));
        return code;
    }
}

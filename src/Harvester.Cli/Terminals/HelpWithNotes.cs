using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.Linq;

namespace Harvester.Cli.Terminals;

/// <summary>The help of a command, followed by notes such as examples.</summary>
internal sealed class HelpWithNotes : SynchronousCommandLineAction
{
    private readonly HelpAction _help;
    private readonly string _notes;

    private HelpWithNotes(HelpAction help, string notes)
    {
        _help = help;
        _notes = notes;
    }

    public override bool ClearsParseErrors => true;

    /// <summary>Gives a command its own --help, which ends with notes.</summary>
    public static void AddTo(Command command, string notes)
    {
        HelpOption? option = command.Options.OfType<HelpOption>().FirstOrDefault();
        if (option is null)
        {
            // Subcommands without notes keep the help option of the root.
            option = new HelpOption { Recursive = false };
            command.Options.Add(option);
        }

        option.Action = new HelpWithNotes((HelpAction)option.Action!, notes);
    }

    public override int Invoke(ParseResult parseResult)
    {
        int code = _help.Invoke(parseResult);
        parseResult.InvocationConfiguration.Output.WriteLine(_notes);
        return code;
    }
}

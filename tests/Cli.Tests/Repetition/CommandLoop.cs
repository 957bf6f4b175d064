using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>
/// Runs writing commands in this process, each again and again in threads and folders of its own, until the process is killed. While a
/// command runs, and only then, its folder has a folder named <see cref="Root"/>.
/// </summary>
internal static class CommandLoop
{
    /// <summary>The folder of a run.</summary>
    public const string Root = "root";

    /// <summary>The line that is printed when the commands begin.</summary>
    public const string Begun = "begun";

    /// <summary>The line that is printed when every command has ended once.</summary>
    public const string AllDone = "all done";

    /// <summary>Runs the commands until standard input ends.</summary>
    /// <param name="inputs">The inputs of the commands.</param>
    /// <param name="trials">The folders of their trials, by name.</param>
    /// <param name="work">Where the commands write: a folder for each thread of each command.</param>
    /// <param name="threads">How many threads run each command.</param>
    /// <param name="names">Names of commands.</param>
    public static int Run(string inputs, string trials, string work, int threads, IReadOnlyCollection<string> names)
    {
        WritingCommand[] commands = [.. WritingCommand.All.Where(command => names.Contains(command.Name))];

        // Worlds take a tenth of the time once their code is compiled and no thread waits for that any more.
        foreach (WritingCommand command in commands.Where(command => command.BuildsWorld))
        {
            Once(command, inputs, BeforeOf(command, trials), FolderOf(work, command, threads));
        }

        using var first = new CountdownEvent(commands.Length * threads);
        foreach (WritingCommand command in commands)
        {
            for (int i = 0; i < threads; i++)
            {
                string folder = FolderOf(work, command, i);
                string before = BeforeOf(command, trials);
                new Thread(() => Repeat(command, inputs, before, folder, first)) { IsBackground = true }.Start();
            }
        }

        Console.WriteLine(Begun);
        new Thread(() => Announce(first)) { IsBackground = true }.Start();
        Console.In.ReadToEnd();
        return 0;
    }

    /// <summary>Where a thread of a command works.</summary>
    public static string FolderOf(string work, WritingCommand command, int thread) => Path.Combine(work, $"{command.Name}-{thread}");

    private static string BeforeOf(WritingCommand command, string trials) => CommandTrial.BeforeIn(Path.Combine(trials, command.Name));

    private static void Announce(CountdownEvent first)
    {
        first.Wait();
        Console.WriteLine(AllDone);
    }

    private static void Repeat(WritingCommand command, string inputs, string before, string folder, CountdownEvent first)
    {
        for (int i = 0; ; i++)
        {
            Once(command, inputs, before, folder);
            if (i == 0)
            {
                first.Signal();
            }
        }
    }

    private static void Once(WritingCommand command, string inputs, string before, string folder)
    {
        string root = Path.Combine(folder, Root);
        string next = Path.Combine(folder, "next");
        string old = Path.Combine(folder, "old");
        Folders.Copy(before, next);
        Directory.Move(next, root);
        CliRun run = CliRun.Of(WritingCommand.WordsOf(command.Words, inputs, root));
        if (run.ExitCode != ExitCode.Done)
        {
            throw new InvalidOperationException($"{command.Name}: {run.Error}");
        }

        Directory.Move(root, old);
        Directory.Delete(old, recursive: true);
    }
}

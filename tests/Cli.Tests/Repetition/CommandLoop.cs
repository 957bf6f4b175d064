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
        using var first = new CountdownEvent(names.Count * threads);
        foreach (WritingCommand command in WritingCommand.All.Where(command => names.Contains(command.Name)))
        {
            for (int i = 0; i < threads; i++)
            {
                string folder = FolderOf(work, command, i);
                string before = CommandTrial.BeforeIn(Path.Combine(trials, command.Name));
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

    private static void Announce(CountdownEvent first)
    {
        first.Wait();
        Console.WriteLine(AllDone);
    }

    private static void Repeat(WritingCommand command, string inputs, string before, string folder, CountdownEvent first)
    {
        string root = Path.Combine(folder, Root);
        string next = Path.Combine(folder, "next");
        string old = Path.Combine(folder, "old");
        for (int i = 0; ; i++)
        {
            Folders.Copy(before, next);
            Directory.Move(next, root);
            CliRun run = CliRun.Of(WritingCommand.WordsOf(command.Words, inputs, root));
            if (run.ExitCode != ExitCode.Done)
            {
                throw new InvalidOperationException($"{command.Name}: {run.Error}");
            }

            Directory.Move(root, old);
            Directory.Delete(old, recursive: true);
            if (i == 0)
            {
                first.Signal();
            }
        }
    }
}

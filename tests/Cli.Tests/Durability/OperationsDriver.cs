using Harvester.Cli.Tests.Repetition;

namespace Harvester.Cli.Tests.Durability;

/// <summary>Runs a command in this process and prints its operations on files, in their order.</summary>
internal static class OperationsDriver
{
    /// <summary>Runs a command.</summary>
    /// <param name="library">The fault injector, which is preloaded.</param>
    /// <param name="folder">The folder whose operations are printed, one a line: kind and path within the folder.</param>
    /// <param name="words">The command line.</param>
    /// <returns>The exit code of the command.</returns>
    public static int Run(string library, string folder, string[] words)
    {
        FaultInjector.Attach(library);
        FaultInjector.Begin(folder, Fault.None);
        CliRun run = CliRun.Of(words);
        FaultInjector.End();
        Console.Error.Write(run.Error);
        foreach (FileOperation operation in FaultInjector.Operations())
        {
            Console.WriteLine($"{operation.Kind} {operation.Path}");
        }

        return run.ExitCode;
    }
}

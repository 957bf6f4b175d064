using System.Globalization;
using Harvester.Cli.Tests.Durability;
using Harvester.Cli.Tests.Repetition;
using Harvester.Cli.Tests.Supervising;

namespace Harvester.Cli.Tests;

/// <summary>The tests as a program: the part of a test that must run in a process of its own.</summary>
internal static class Program
{
    private static int Main(string[] arguments) =>
        arguments switch
        {
            ["faults", var library, var inputs, var folder] => FaultDriver.Run(library, inputs, folder),
            ["loop", var inputs, var trials, var work, var threads, .. var names] => CommandLoop.Run(
                inputs,
                trials,
                work,
                int.Parse(threads, CultureInfo.InvariantCulture),
                names
            ),
            ["stand-in", var folder, var behaviour, .. var more] => StandIn.Run(folder, behaviour, more),
            ["operations", var library, var folder, .. var words] => OperationsDriver.Run(library, folder, words),
            _ => throw new ArgumentException("Run the tests with dotnet test."),
        };
}

using System.CommandLine;

namespace Harvester.Cli.Terminals;

/// <summary>A command whose result is what it prints, so that --quiet does not silence it.</summary>
/// <param name="name">The word that calls it.</param>
/// <param name="description">What it does, in one sentence.</param>
internal sealed class ResultCommand(string name, string description) : Command(name, description);

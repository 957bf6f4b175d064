using System.Text.RegularExpressions;
using Mono.Cecil;
using Mono.Cecil.Cil;

namespace Harvester.Architecture.Tests;

/// <summary>Messages are one finished line, and those of the core leave options and settings to the front ends.</summary>
public sealed class MessageTests
{
    // The last string of a statement that throws, tells or reports; shorter texts than a sentence are names.
    private const string Statement =
        """(?:throw new \w+Exception|new CaptureFault|Tell|WriteError)\((?:[^;"]|"(?:[^"\\]|\\.)*")*?"""
        + """\"(?<text>(?:[^"\\]|\\.)* (?:[^"\\]|\\.)*)"(?:, \w+)?\)+;""";

    [Theory]
    [InlineData("Harvester.Sessions")]
    [InlineData("Harvester.Capture")]
    [InlineData("Harvester.Driving")]
    [InlineData("Harvester.Play")]
    [InlineData("Harvester.Mod")]
    [InlineData("Harvester.Datasets")]
    [InlineData("Harvester.Exports")]
    [InlineData("Harvester.Reports")]
    [InlineData("Harvester.Runs")]
    [InlineData("Harvester.Cli")]
    public void Messages_are_one_line_and_end_as_sentences(string project)
    {
        string[] messages =
        [
            .. Repository
                .SourcesOf(project)
                .SelectMany(path => Regex.Matches(File.ReadAllText(path), Statement).Select(match => match.Groups["text"].Value)),
        ];

        Assert.NotEmpty(messages);
        // A message may end with the text of another fault.
        string[] unfinished =
        [
            .. messages.Where(message =>
                message.Contains("\\n", StringComparison.Ordinal) || !".!?})".Contains(message[^1], StringComparison.Ordinal)
            ),
        ];
        Assert.Empty(unfinished);
    }

    [Theory]
    [InlineData("Harvester.Geometry")]
    [InlineData("Harvester.Sessions")]
    [InlineData("Harvester.Capture")]
    public void Core_messages_name_no_option_and_no_setting(string project)
    {
        using AssemblyDefinition assembly = AssemblyDefinition.ReadAssembly(Repository.AssemblyOf(project));
        string[] sentences =
        [
            .. assembly
                .MainModule.GetTypes()
                // The compiler prints the names of a record's properties.
                .SelectMany(type => type.Methods)
                .Where(method => method.HasBody && method.Name != "PrintMembers")
                .SelectMany(method => method.Body.Instructions)
                .Where(instruction => instruction.OpCode == OpCodes.Ldstr)
                .Select(instruction => (string)instruction.Operand)
                .Where(text => text.Contains(' ', StringComparison.Ordinal)),
        ];
        string settings = string.Join('|', SettingNames());

        Assert.NotEmpty(sentences);
        string[] naming = [.. sentences.Where(text => Regex.IsMatch(text, $@"--[a-z]|\bini\b|(in|under) \[[A-Z]|\b({settings})\b"))];
        Assert.Empty(naming);
    }

    /// <summary>The keys of the mod's ini file that no English sentence contains by chance: those of several words.</summary>
    private static string[] SettingNames()
    {
        string ini = File.ReadAllText(Path.Combine(Repository.Root, "src", "Harvester.Mod", "GtaDataHarvester.ini"));
        const string key = @"^;?\s*(?<name>[A-Z][a-z0-9]+([A-Z][a-z0-9]*)+) =";
        string[] names = [.. Regex.Matches(ini, key, RegexOptions.Multiline).Select(match => match.Groups["name"].Value)];
        Assert.Contains("MaxPictureLagTicks", names);
        return names;
    }
}

using Harvester.TestSupport;
using Mono.Cecil;

namespace Harvester.Mod.Tests;

/// <summary>The dll that the build made for the game.</summary>
internal static class BuiltMod
{
    public static string RepositoryRoot { get; } = RepositoryFolder.Path;

    public static string Configuration { get; } = new DirectoryInfo(AppContext.BaseDirectory).Parent!.Name;

    public static string Path { get; } = Find();

    /// <summary>The members and types of the game's API that the dll refers to, as signatures.</summary>
    public static IReadOnlyList<string> GameApiReferences()
    {
        using ModuleDefinition module = ModuleDefinition.ReadModule(Path);
        IEnumerable<string> types = module.GetTypeReferences().Where(IsGameApi).Select(type => type.FullName);
        IEnumerable<string> members = module
            .GetMemberReferences()
            .Where(member => IsGameApi(member.DeclaringType))
            .Select(member => member.FullName);
        return types.Concat(members).Distinct().Order(StringComparer.Ordinal).ToArray();
    }

    private static bool IsGameApi(TypeReference type) => type.GetElementType().Scope.Name == "ScriptHookVDotNet3";

    private static string Find()
    {
        string bin = System.IO.Path.Combine(RepositoryRoot, "src", "Harvester.Mod", "bin", Configuration);
        return Directory.EnumerateFiles(bin, "GtaDataHarvester.dll", SearchOption.AllDirectories).First();
    }
}

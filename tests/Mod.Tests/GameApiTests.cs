using Mono.Cecil;

namespace Harvester.Mod.Tests;

/// <summary>The built dll must load under API 3.6.0 and everything later: it may name only what 3.6.0 has.</summary>
public sealed class GameApiTests
{
    [Fact]
    public void Built_mod_uses_only_listed_api_members()
    {
        string[] known = File.ReadLines(Path.Combine(AppContext.BaseDirectory, "api-3.6.0.txt"))
            .Select(line => line.Trim())
            .Where(line => line.Length > 0 && line[0] != '#')
            .ToArray();
        IReadOnlyList<string> used = BuiltMod.GameApiReferences();

        Assert.NotEmpty(used);
        Assert.Empty(used.Except(known));
    }

    [Fact]
    public void Built_mod_refers_to_the_unsigned_api_of_3_6_0()
    {
        using ModuleDefinition module = ModuleDefinition.ReadModule(BuiltMod.Path);
        AssemblyNameReference api = Assert.Single(
            module.AssemblyReferences,
            reference => reference.Name.StartsWith("ScriptHookVDotNet", StringComparison.Ordinal)
        );

        Assert.Equal("ScriptHookVDotNet3", api.Name);
        Assert.Equal(new Version(3, 6, 0, 0), api.Version);
        Assert.Empty(api.PublicKeyToken);
    }

    [Fact]
    public void Built_mod_references_only_assemblies_of_the_framework()
    {
        string[] allowed =
        [
            "mscorlib",
            "System",
            "System.Core",
            "System.Drawing",
            "System.IO.Compression",
            "System.Windows.Forms",
            "System.Xml",
            "ScriptHookVDotNet3",
        ];
        using ModuleDefinition module = ModuleDefinition.ReadModule(BuiltMod.Path);

        Assert.Empty(module.AssemblyReferences.Select(reference => reference.Name).Except(allowed));
    }

    [Fact]
    public void Built_mod_has_one_script_with_a_public_default_constructor()
    {
        using ModuleDefinition module = ModuleDefinition.ReadModule(BuiltMod.Path);
        TypeDefinition script = Assert.Single(module.Types, type => type.BaseType?.FullName == "GTA.Script");

        Assert.True(script.IsPublic && !script.IsAbstract);
        Assert.Contains(script.Methods, method => method.IsConstructor && method.IsPublic && !method.HasParameters && !method.IsStatic);
    }
}

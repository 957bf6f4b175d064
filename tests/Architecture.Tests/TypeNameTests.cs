using Mono.Cecil;

namespace Harvester.Architecture.Tests;

/// <summary>The names of the types of all projects, read from what was built.</summary>
public sealed class TypeNameTests
{
    [Fact]
    public void No_type_name_stands_twice()
    {
        var places = new Dictionary<string, HashSet<string>>(StringComparer.Ordinal);
        foreach (string project in ProjectReferenceTests.Projects)
        {
            using AssemblyDefinition assembly = AssemblyDefinition.ReadAssembly(Repository.AssemblyOf(project));
            foreach (TypeDefinition type in assembly.MainModule.Types.Where(type => IsOf(type, project)))
            {
                places.TryAdd(type.Name, []);
                places[type.Name].Add(type.FullName);
            }
        }

        Assert.True(places.Count > 1000, $"Only {places.Count} types were read.");
        Assert.Empty(places.Values.Where(names => names.Count > 1).Select(names => string.Join(", ", names)));
    }

    /// <summary>Whether a project's own sources have a type; the mod's dll also has those of other projects.</summary>
    private static bool IsOf(TypeDefinition type, string project) =>
        !type.Name.Contains('<', StringComparison.Ordinal)
        && (type.Namespace == project || type.Namespace.StartsWith(project + ".", StringComparison.Ordinal));
}

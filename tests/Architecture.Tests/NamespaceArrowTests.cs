using Mono.Cecil;

namespace Harvester.Architecture.Tests;

/// <summary>The arrows between namespaces within each project, read from the types that the built code uses.</summary>
public sealed class NamespaceArrowTests
{
    [Theory]
    [MemberData(nameof(ProjectReferenceTests.Projects), MemberType = typeof(ProjectReferenceTests))]
    public void Namespaces_of_a_project_form_no_cycle(string project)
    {
        NamespaceGraph graph = GraphOf(project);

        IReadOnlyList<string> cycle = graph.FindCycle();

        Assert.True(cycle.Count == 0, $"{string.Join(" -> ", cycle)}: {graph.ExamplesAlong(cycle)}");
    }

    [Theory]
    [MemberData(nameof(ProjectReferenceTests.Projects), MemberType = typeof(ProjectReferenceTests))]
    public void Namespace_of_a_file_is_its_folder(string project)
    {
        string root = Path.Combine(Repository.Root, "src", project);

        IEnumerable<string> elsewhere =
            from path in Repository.SourcesOf(project)
            let folder = Path.GetRelativePath(root, Path.GetDirectoryName(path)!)
            let expected = folder == "." ? project : $"{project}.{folder.Replace(Path.DirectorySeparatorChar, '.')}"
            let line = File.ReadLines(path).FirstOrDefault(text => text.StartsWith("namespace ", StringComparison.Ordinal))
            where line is not null && line != $"namespace {expected};"
            select $"{Path.GetRelativePath(Repository.Root, path)}: {line}";

        Assert.Empty(elsewhere);
    }

    private static NamespaceGraph GraphOf(string project)
    {
        using AssemblyDefinition assembly = AssemblyDefinition.ReadAssembly(Repository.AssemblyOf(project));
        return NamespaceGraph.Of(assembly.MainModule, project);
    }
}

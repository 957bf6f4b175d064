using Mono.Cecil;

namespace Harvester.Architecture.Tests;

/// <summary>The folders of all projects are those of docs/architecture.md, in an order in which each uses only those before it.</summary>
public sealed class FolderOrderTests
{
    [Theory]
    [MemberData(nameof(ProjectReferenceTests.Projects), MemberType = typeof(ProjectReferenceTests))]
    public void Table_has_every_folder_of_a_project_once(string project)
    {
        string root = Path.Combine(Repository.Root, "src", project);
        string[] folders =
        [
            .. Repository
                .SourcesOf(project)
                .Select(path => Path.GetRelativePath(root, path).Split(Path.DirectorySeparatorChar))
                .Where(parts => parts.Length > 1)
                .Select(parts => parts[0])
                .Distinct()
                .Order(StringComparer.Ordinal),
        ];

        Assert.Equal(folders, FolderTable.Of(project).Order(StringComparer.Ordinal));
    }

    [Theory]
    [MemberData(nameof(ProjectReferenceTests.Projects), MemberType = typeof(ProjectReferenceTests))]
    public void Folder_uses_only_those_before_it_in_the_table(string project)
    {
        using AssemblyDefinition assembly = AssemblyDefinition.ReadAssembly(Repository.AssemblyOf(project));
        var graph = NamespaceGraph.Of(assembly.MainModule, project);

        // The files beside the folders are what all folders may use.
        string[] order = [string.Empty, .. FolderTable.Of(project)];
        IEnumerable<string> upward =
            from arrow in graph.Arrows
            let user = FolderOf(arrow.From, project)
            let used = FolderOf(arrow.To, project)
            where Array.IndexOf(order, user) < Array.IndexOf(order, used)
            select $"{user} -> {used}: {arrow.Example}";

        Assert.Empty(upward);
    }

    [Fact]
    public void Table_names_only_projects()
    {
        string[] projects = [.. ProjectReferenceTests.Projects];

        Assert.NotEmpty(FolderTable.Projects);
        Assert.Empty(FolderTable.Projects.Except(projects));
    }

    [Fact]
    public void Rows_of_the_table_are_read_in_their_order()
    {
        string[] page = ["## Folders", "", "| **One** | |", "| `B`, `A` | as `C` |", "| **Two** | a project |", "## Next", "| `D` | |"];

        Dictionary<string, List<string>> table = FolderTable.Read(page);

        Assert.Equal(["Harvester.One", "Harvester.Two"], table.Keys);
        Assert.Equal(["B", "A"], table["Harvester.One"]);
        Assert.Empty(table["Harvester.Two"]);
    }

    /// <summary>The outermost folder of a namespace; empty for that of the project itself.</summary>
    private static string FolderOf(string name, string project) =>
        name == project ? string.Empty : name[(project.Length + 1)..].Split('.')[0];
}

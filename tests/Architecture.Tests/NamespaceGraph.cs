using Mono.Cecil;
using Mono.Cecil.Cil;

namespace Harvester.Architecture.Tests;

/// <summary>
/// Which namespaces of a module use which others of it: an arrow for every type that a base, a member, an attribute or a method body names.
/// </summary>
internal sealed class NamespaceGraph
{
    private readonly Dictionary<string, Dictionary<string, string>> _arrows = new(StringComparer.Ordinal);
    private readonly string _root;

    private NamespaceGraph(string root) => _root = root;

    /// <summary>The graph of the namespaces at or below a root.</summary>
    public static NamespaceGraph Of(ModuleDefinition module, string root)
    {
        var graph = new NamespaceGraph(root);
        foreach (TypeDefinition type in module.GetTypes())
        {
            graph.Add(type);
        }

        return graph;
    }

    /// <summary>All arrows, each with a use of a type.</summary>
    public IEnumerable<(string From, string To, string Example)> Arrows =>
        _arrows.SelectMany(from => from.Value.Select(to => (from.Key, to.Key, to.Value)));

    /// <summary>Namespaces along a cycle, the first again at the end; empty where there is none.</summary>
    public IReadOnlyList<string> FindCycle()
    {
        var done = new HashSet<string>(StringComparer.Ordinal);
        foreach (string start in _arrows.Keys.Order(StringComparer.Ordinal))
        {
            var path = new List<string>();
            if (Search(start, path, done))
            {
                return path[path.IndexOf(path[^1])..];
            }
        }

        return [];
    }

    /// <summary>A use of a type for each arrow of a path.</summary>
    public string ExamplesAlong(IReadOnlyList<string> path) => string.Join("; ", path.Zip(path.Skip(1), (from, to) => _arrows[from][to]));

    private bool Search(string current, List<string> path, HashSet<string> done)
    {
        if (done.Contains(current))
        {
            return false;
        }

        bool isCycle = path.Contains(current);
        path.Add(current);
        if (isCycle)
        {
            return true;
        }

        foreach (
            string next in _arrows.TryGetValue(current, out Dictionary<string, string>? arrows)
                ? arrows.Keys.Order(StringComparer.Ordinal)
                : Enumerable.Empty<string>()
        )
        {
            if (Search(next, path, done))
            {
                return true;
            }
        }

        path.RemoveAt(path.Count - 1);
        done.Add(current);
        return false;
    }

    private void Add(TypeDefinition type)
    {
        Use(type, type.BaseType);
        foreach (InterfaceImplementation implementation in type.Interfaces)
        {
            Use(type, implementation.InterfaceType);
        }

        UseAttributes(type, type);
        foreach (FieldDefinition field in type.Fields)
        {
            Use(type, field.FieldType);
            UseAttributes(type, field);
        }

        foreach (MethodDefinition method in type.Methods)
        {
            UseSignature(type, method);
            UseAttributes(type, method);
            if (method.HasBody)
            {
                UseBody(type, method.Body);
            }
        }
    }

    private void UseBody(TypeDefinition type, MethodBody body)
    {
        foreach (VariableDefinition variable in body.Variables)
        {
            Use(type, variable.VariableType);
        }

        foreach (Instruction instruction in body.Instructions)
        {
            switch (instruction.Operand)
            {
                case TypeReference used:
                    Use(type, used);
                    break;
                case MethodReference method:
                    Use(type, method.DeclaringType);
                    UseSignature(type, method);
                    break;
                case FieldReference field:
                    Use(type, field.DeclaringType);
                    Use(type, field.FieldType);
                    break;
            }
        }
    }

    private void UseSignature(TypeDefinition type, MethodReference method)
    {
        Use(type, method.ReturnType);
        foreach (ParameterDefinition parameter in method.Parameters)
        {
            Use(type, parameter.ParameterType);
        }

        if (method is GenericInstanceMethod generic)
        {
            foreach (TypeReference argument in generic.GenericArguments)
            {
                Use(type, argument);
            }
        }
    }

    private void UseAttributes(TypeDefinition type, ICustomAttributeProvider provider)
    {
        foreach (CustomAttribute attribute in provider.CustomAttributes)
        {
            Use(type, attribute.AttributeType);
        }
    }

    private void Use(TypeDefinition user, TypeReference? used)
    {
        switch (used)
        {
            case null or GenericParameter:
                return;
            case GenericInstanceType generic:
                foreach (TypeReference argument in generic.GenericArguments)
                {
                    Use(user, argument);
                }

                break;
        }

        string from = NamespaceOf(user);
        string to = NamespaceOf(used.GetElementType());
        if (from != to && IsWithin(from) && IsWithin(to))
        {
            if (!_arrows.TryGetValue(from, out Dictionary<string, string>? arrows))
            {
                _arrows[from] = arrows = new Dictionary<string, string>(StringComparer.Ordinal);
            }

            arrows.TryAdd(to, $"{user.Name} uses {used.Name}");
        }
    }

    private bool IsWithin(string name) => name == _root || name.StartsWith(_root + ".", StringComparison.Ordinal);

    private static string NamespaceOf(TypeReference type) => type.DeclaringType is { } outer ? NamespaceOf(outer) : type.Namespace;
}
